package urbi.rtp;

import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;
import urbi.wire.WireInput;
import urbi.wire.WireOutput;

/**
 * One end of the datagram exchange between a process with UObjects and the kernel. Its methods may
 * be called from any thread.
 */
public final class RtpSession {
  /**
   * What a session needs from its owner. The methods may be called from any thread, and must not
   * wait.
   */
  public interface Environment {
    /** Sends a datagram to the other end; it may get lost. */
    void send(byte[] datagram);

    /** Has something done by the thread that sends. */
    void run(Runnable task);

    /** Has something done by that thread, after a while. */
    void after(long milliseconds, Runnable task);

    /** The time, from any beginning. */
    long microseconds();

    /** A frame has come; told by the thread that receives. */
    void take(int variable, byte[] frame);

    /** A probe has been answered: datagrams go both ways. */
    void answered();

    /** Nothing gets through any more; told once. */
    void broken();
  }

  /** What has come is reported after that time, if it is not much before. */
  private static final long REPORT_MILLISECONDS = 20;

  private final RtpParameters own;
  private final RtpParameters other;
  private final Environment environment;
  private final RtpStatistics counts = new RtpStatistics();
  private final RtpSender sender;
  private final RtpReceiver receiver;
  private final AtomicBoolean reporting = new AtomicBoolean();
  private volatile boolean active;

  /**
   * @param own what this end has told the other
   * @param other what the other has told this one
   */
  public RtpSession(RtpParameters own, RtpParameters other, Environment environment) {
    this.own = own;
    this.other = other;
    this.environment = environment;
    this.sender = new RtpSender(own, other, counts, new PeerOutput());
    this.receiver = new RtpReceiver(own, other, counts);
  }

  private final class PeerOutput implements RtpSender.DatagramOutput {
    @Override
    public void send(byte[] datagram) {
      environment.send(datagram);
    }

    @Override
    public void after(long milliseconds, Runnable task) {
      environment.after(milliseconds, task);
    }

    @Override
    public long microseconds() {
      return environment.microseconds();
    }

    @Override
    public void broken() {
      active = false;
      environment.broken();
    }
  }

  /** What became of the frames. */
  public RtpStatistics counts() {
    return counts;
  }

  /**
   * Whether values may be sent: a probe has come through, and nothing is known against it since.
   */
  public boolean isActive() {
    return active;
  }

  public void setActive(boolean on) {
    active = on;
  }

  /** Asks the other end for a sign of life. */
  public void probe() {
    environment.send(RtcpPacket.probe(RtcpPacket.Kind.PROBE, own.ssrc(), other.token()).toBytes());
  }

  // ------------------------------------------------------------------ sending

  /**
   * Sends a frame.
   *
   * @param binary whether it has a binary, so that the variable gets a stream of its own
   * @return false if it has to go over the connection
   */
  public boolean send(int variable, boolean binary, byte[] frame) {
    if (!active || !sender.offer(variable, binary, frame)) {
      return false;
    }
    environment.run(sender::sendPending);
    return true;
  }

  /**
   * The next value of a variable is sent over the connection: before it, writes the frame there
   * that says so, if the last one was not.
   */
  public void leave(int variable, WireOutput out, int frame) {
    RtpSender.Superseded superseded = sender.superseded(variable);
    if (superseded != null) {
      out.begin(frame).size(variable).size(superseded.ssrc()).size(superseded.sequence()).end();
    }
  }

  /** The variable is used no more. */
  public void close(int variable) {
    sender.close(variable);
  }

  // ------------------------------------------------------------------ receiving

  /** What {@link #leave} has written at the other end has come: the fields of the frame. */
  public void left(WireInput in) {
    int variable = in.size();
    receiver.superseded(variable, new RtpSender.Superseded(in.size(), in.size() & 0xffff));
  }

  /** The token of a datagram; 0 if it has none. */
  public static long token(byte[] bytes, int length) {
    if (RtcpPacket.is(bytes, length)) {
      RtcpPacket packet = RtcpPacket.read(bytes, length);
      return packet == null ? 0 : packet.token();
    }
    RtpPacket packet = RtpPacket.read(bytes, length);
    return packet == null ? 0 : packet.token();
  }

  /** Takes a datagram; one that is not from the other end is dropped. */
  public void receive(byte[] bytes, int length) {
    if (RtcpPacket.is(bytes, length)) {
      control(RtcpPacket.read(bytes, length));
      return;
    }
    RtpPacket packet = RtpPacket.read(bytes, length);
    if (packet == null || packet.token() != own.token()) {
      counts.refused.increment();
      return;
    }
    byte[] frame = receiver.take(packet);
    report(false);
    if (reporting.compareAndSet(false, true)) {
      environment.after(
          REPORT_MILLISECONDS,
          () -> {
            reporting.set(false);
            report(true);
          });
    }
    if (frame != null) {
      environment.take(packet.variable(), frame);
    }
  }

  private void report(boolean now) {
    RtcpPacket report = receiver.report(now);
    if (report != null) {
      environment.send(report.toBytes());
    }
  }

  private void control(@Nullable RtcpPacket packet) {
    if (packet == null || packet.token() != own.token()) {
      counts.refused.increment();
      return;
    }
    switch (packet.kind()) {
      case REPORT -> {
        Map<Integer, Integer> highest = packet.highest();
        environment.run(() -> sender.reported(highest));
      }
      case PROBE ->
          environment.send(
              RtcpPacket.probe(RtcpPacket.Kind.ANSWER, own.ssrc(), other.token()).toBytes());
      case ANSWER -> environment.answered();
    }
  }
}
