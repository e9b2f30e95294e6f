package urbi.remote;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.SocketException;
import java.security.SecureRandom;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import urbi.UClientException;
import urbi.UDataType;
import urbi.UValue;
import urbi.rtp.RtpOptions;
import urbi.rtp.RtpParameters;
import urbi.rtp.RtpSession;
import urbi.rtp.RtpStatistics;
import urbi.spi.ComponentFailureLog;
import urbi.thread.GuardedThreads;
import urbi.time.Stopwatch;
import urbi.wire.Frame;
import urbi.wire.WireException;
import urbi.wire.WireInput;
import urbi.wire.WireOutput;

/** The datagrams of a remote process: negotiates them with the kernel, sends and receives them. */
final class RemoteDatagrams implements AutoCloseable {
  private static final int BUFFER = 4 << 20;
  private static final long PROBE_MILLISECONDS = 50;

  private final RemoteContext context;
  private final InetAddress server;
  private final ComponentFailureLog failureLog;
  private @Nullable RtpOptions options;
  private CompletableFuture<Boolean> works = new CompletableFuture<>();
  private volatile @Nullable DatagramSocketThreads path;
  private boolean closed;

  RemoteDatagrams(RemoteContext context, InetAddress server, ComponentFailureLog failureLog) {
    this.context = context;
    this.server = server;
    this.failureLog = failureLog;
  }

  // ------------------------------------------------------------------ agreement

  /** Offers datagrams to the kernel. */
  synchronized CompletableFuture<Boolean> use(RtpOptions wanted) {
    if (works.isDone()) {
      works = new CompletableFuture<>();
    }
    options = wanted;
    offer(wanted);
    return works.copy();
  }

  private void offer(RtpOptions wanted) {
    end();
    try {
      var offered = new DatagramSocketThreads(new DatagramSocket(), wanted);
      path = offered;
      RtpParameters own = offered.own;
      context.sendNow(out -> own.write(out.begin(Frame.RTP_OFFER)).end());
    } catch (IOException e) {
      fails("no datagrams: " + e.getMessage());
    }
  }

  /** The kernel says something about datagrams; on the thread that reads. */
  void take(int type, WireInput frame) {
    switch (type) {
      case Frame.LEFT -> {
        DatagramSocketThreads present = path;
        if (present != null && present.session != null) {
          present.session.left(frame);
        }
      }
      case Frame.RTP_LOADED -> loaded();
      case Frame.RTP_TERMS -> accepted(frame.number(), RtpParameters.read(frame));
      default -> refused(frame.text());
    }
  }

  private synchronized void loaded() {
    if (options != null && !closed) {
      if (works.isDone()) {
        works = new CompletableFuture<>();
      }
      offer(options);
    }
  }

  /**
   * The kernel takes up an offer.
   *
   * @param token that of the offer: it may be another one than the last
   */
  private synchronized void accepted(long token, RtpParameters other) {
    DatagramSocketThreads present = path;
    if (present != null && present.own.token() == token && present.session == null && !closed) {
      present.begin(other);
    }
  }

  /** The kernel takes no datagrams: its module is not loaded, or not any more; it may be later. */
  private synchronized void refused(String why) {
    end();
    fails(why);
  }

  private synchronized void fails(String why) {
    if (!closed) {
      context.report("RTP is not used: " + why);
    }
    works.complete(false);
  }

  private void end() {
    DatagramSocketThreads old = path;
    path = null;
    if (old != null) {
      old.close();
    }
  }

  // ------------------------------------------------------------------ values

  /** Sends the value of a variable; false if it has to go over the connection. */
  boolean set(int variable, UValue value) {
    DatagramSocketThreads present = path;
    if (present == null || present.session == null || !present.session.isActive()) {
      return false;
    }
    byte[] frame =
        new WireOutput(1 << 6).begin(Frame.SET).size(variable).value(value).end().inside();
    return present.session.send(variable, value.getType() == UDataType.DATA_BINARY, frame);
  }

  /** The next value of a variable goes over the connection, in this output. */
  void leave(int variable, WireOutput out) {
    DatagramSocketThreads present = path;
    if (present != null && present.session != null) {
      present.session.leave(variable, out, Frame.LEFT);
    }
  }

  void forget(int variable) {
    DatagramSocketThreads present = path;
    if (present != null && present.session != null) {
      present.session.close(variable);
    }
  }

  @Nullable RtpStatistics counts() {
    DatagramSocketThreads present = path;
    return present == null || present.session == null ? null : present.session.counts();
  }

  @Override
  public synchronized void close() {
    closed = true;
    end();
    works.complete(false);
  }

  // ------------------------------------------------------------------ one agreement

  /** A socket, and the threads that it needs. */
  private final class DatagramSocketThreads implements RtpSession.Environment, AutoCloseable {
    private final DatagramSocket socket;
    private final RtpOptions options;
    private final RtpParameters own;
    private final ScheduledThreadPoolExecutor clock;
    private final Map<Integer, byte[]> arrived = new LinkedHashMap<>();
    private volatile @Nullable RtpSession session;
    private @Nullable Thread delivery;
    private long probes;

    DatagramSocketThreads(DatagramSocket socket, RtpOptions options) throws SocketException {
      this.socket = socket;
      this.options = options;
      socket.setReceiveBufferSize(BUFFER);
      socket.setSendBufferSize(BUFFER);
      int suitable =
          server.isLoopbackAddress()
              ? RtpParameters.LOOPBACK_DATAGRAM
              : RtpParameters.DEFAULT_DATAGRAM;
      SecureRandom random = new SecureRandom();
      own =
          new RtpParameters(
              socket.getLocalPort(),
              random.nextInt(),
              random.nextLong(),
              socket.getReceiveBufferSize(),
              options.datagram() == 0 ? suitable : options.datagram());
      clock = GuardedThreads.SDK.clock("urbi-remote-rtp");
      clock.setRemoveOnCancelPolicy(true);
    }

    void begin(RtpParameters other) {
      socket.connect(server, options.port() == 0 ? other.port() : options.port());
      var begun = new RtpSession(own, other, this);
      session = begun;
      probes = Math.max(1, options.patience().toMillis() / PROBE_MILLISECONDS);
      GuardedThreads threads = GuardedThreads.SDK;
      var receiver = new DatagramReceiver(socket, begun::receive, this::broken, failureLog);
      threads.platform("urbi-remote-rtp-in", receiver, defect -> broken()).start();
      delivery = threads.platform("urbi-remote-rtp-values", this::deliver, defect -> broken());
      delivery.start();
      after(0, () -> probe(begun));
    }

    private void probe(RtpSession session) {
      if (session.isActive() || path != this) {
        return;
      }
      if (probes-- > 0) {
        session.probe();
        after(PROBE_MILLISECONDS, () -> probe(session));
      } else {
        gaveUp("do not get through to " + server.getHostAddress() + ":" + socket.getPort());
      }
    }

    @Override
    public void send(byte[] datagram) {
      try {
        socket.send(new DatagramPacket(datagram, datagram.length));
      } catch (IOException e) {
        // It is lost, as any may be.
      }
    }

    @Override
    public void run(Runnable task) {
      task.run();
    }

    @Override
    public void after(long milliseconds, Runnable task) {
      try {
        clock.schedule(task, milliseconds, TimeUnit.MILLISECONDS);
      } catch (RejectedExecutionException e) {
        // It is over.
      }
    }

    @Override
    public long microseconds() {
      return TimeUnit.NANOSECONDS.toMicros(Stopwatch.nanoseconds());
    }

    @Override
    public void answered() {
      synchronized (RemoteDatagrams.this) {
        RtpSession begun = session;
        if (path == this && begun != null && !begun.isActive()) {
          begun.setActive(true);
          context.sendNow(out -> out.begin(Frame.RTP_ACTIVE).octet(1).end());
          works.complete(true);
        }
      }
    }

    @Override
    public void broken() {
      gaveUp("do not get through any more");
    }

    /** Ends this agreement, but not one that has taken its place. */
    private void gaveUp(String why) {
      synchronized (RemoteDatagrams.this) {
        if (path != this) {
          return;
        }
        try {
          context.sendNow(out -> out.begin(Frame.RTP_ACTIVE).octet(0).end());
          refused("datagrams " + why);
        } catch (UClientException e) {
          // There is no connection any more either.
        }
      }
    }

    /** Of a variable whose values come faster than they are taken, the newest one is taken. */
    @Override
    public void take(int variable, byte[] frame) {
      synchronized (arrived) {
        arrived.put(variable, frame);
        arrived.notifyAll();
      }
    }

    private void deliver() {
      try {
        while (true) {
          byte[] frame = next();
          try {
            WireInput in = new WireInput(frame, 0, frame.length);
            if (in.octet() == Frame.CHANGED) {
              context.changedInDatagram(in);
            }
          } catch (WireException e) {
            // It is dropped, as are other datagrams that make no sense.
          } catch (RuntimeException | Error e) {
            failureLog.log("a value in a datagram", e);
          }
        }
      } catch (InterruptedException e) {
        // It is over.
      }
    }

    private byte[] next() throws InterruptedException {
      synchronized (arrived) {
        while (arrived.isEmpty()) {
          arrived.wait();
        }
        Iterator<byte[]> first = arrived.values().iterator();
        byte[] frame = first.next();
        first.remove();
        return frame;
      }
    }

    @Override
    public void close() {
      socket.close();
      clock.shutdownNow();
      if (delivery != null) {
        delivery.interrupt();
      }
    }
  }
}
