package org.urbi.server.net;

import io.netty.buffer.Unpooled;
import io.netty.channel.Channel;
import io.netty.channel.ChannelOption;
import io.netty.channel.socket.DatagramPacket;
import io.netty.util.concurrent.EventExecutor;
import java.net.InetSocketAddress;
import java.security.SecureRandom;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import urbi.rtp.RtpParameters;
import urbi.rtp.RtpSession;
import urbi.wire.Frame;
import urbi.wire.WireOutput;

/**
 * The datagrams of one connection. They are sent to the address from which its last valid datagram
 * came.
 */
final class FrameDatagrams implements RtpSession.Environment {
  private final EventExecutor thread;
  private final DatagramPort port;
  private final Consumer<byte[]> answers;
  private final Consumer<byte[]> values;
  private volatile @Nullable RtpSession session;
  private volatile @Nullable InetSocketAddress process;
  private @Nullable Channel channel;
  private long token;
  private boolean over;

  /**
   * @param answers sends frames over the connection
   * @param values takes the frames that have come in datagrams
   */
  FrameDatagrams(
      EventExecutor thread, DatagramPort port, Consumer<byte[]> answers, Consumer<byte[]> values) {
    this.thread = thread;
    this.port = port;
    this.answers = answers;
    this.values = values;
  }

  /** Null if there are no datagrams. */
  @Nullable RtpSession session() {
    return session;
  }

  /** Accepts an offer. Any thread may call this. */
  void open(RtpParameters other) {
    NetworkThread.execute(thread, () -> port.open(opened -> begin(opened, other), this::refuse));
  }

  private void begin(Channel opened, RtpParameters other) {
    end();
    if (over) {
      return;
    }
    channel = opened;
    SecureRandom random = new SecureRandom();
    token = random.nextLong();
    RtpParameters own =
        new RtpParameters(
            ((InetSocketAddress) opened.localAddress()).getPort(),
            random.nextInt(),
            token,
            opened.config().getOption(ChannelOption.SO_RCVBUF),
            other.datagram());
    RtpSession begun = new RtpSession(own, other, this);
    session = begun;
    port.add(
        token,
        (datagram, sender) -> {
          process = sender;
          begun.receive(datagram, datagram.length);
        });
    answers.accept(
        own.write(new WireOutput(1 << 6).begin(Frame.RTP_TERMS).number(other.token()))
            .end()
            .toBytes());
  }

  /** Declines an offer; by any thread. */
  void refuse(String why) {
    byte[] answer = new WireOutput(1 << 6).begin(Frame.RTP_REFUSED).text(why).end().toBytes();
    NetworkThread.execute(thread, () -> answers.accept(answer));
  }

  /** Ends them; by any thread. */
  void close() {
    NetworkThread.execute(thread, this::end);
  }

  /** The connection is lost. */
  void lost() {
    over = true;
    end();
  }

  private void end() {
    RtpSession ended = session;
    if (ended != null) {
      ended.setActive(false);
      session = null;
      process = null;
      port.remove(token);
    }
  }

  // ------------------------------------------------------------------ around the session

  @Override
  public void send(byte[] datagram) {
    InetSocketAddress to = process;
    if (to != null && channel != null) {
      channel.writeAndFlush(new DatagramPacket(Unpooled.wrappedBuffer(datagram), to));
    }
  }

  @Override
  public void run(Runnable task) {
    NetworkThread.execute(thread, task);
  }

  @Override
  public void after(long milliseconds, Runnable task) {
    try {
      thread.schedule(task, milliseconds, TimeUnit.MILLISECONDS);
    } catch (RejectedExecutionException e) {
      // The server has been closed.
    }
  }

  @Override
  public long microseconds() {
    return TimeUnit.NANOSECONDS.toMicros(thread.ticker().nanoTime());
  }

  @Override
  public void take(int variable, byte[] frame) {
    values.accept(frame);
  }

  @Override
  public void answered() {
    // The process tells over the connection that datagrams get through, see Frame.RTP_ACTIVE.
  }

  @Override
  public void broken() {
    // Values go over the connection from now on.
  }
}
