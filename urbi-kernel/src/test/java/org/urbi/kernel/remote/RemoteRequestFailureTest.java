package org.urbi.kernel.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.TestTimeout;
import urbi.rtp.RtpParameters;
import urbi.rtp.RtpSession;
import urbi.wire.Frame;
import urbi.wire.WireInput;
import urbi.wire.WireOutput;

/** What a remote process is told, and what is logged, when its request fails. */
class RemoteRequestFailureTest {
  private final BlockingQueue<String> kernelLog = new LinkedBlockingQueue<>();
  private final ByteArrayOutputStream log = new ByteArrayOutputStream();
  private final PrintStream before = System.err;
  private final BrokenTransport transport = new BrokenTransport();
  private Kernel kernel;
  private RemotePeer peer;

  /** Keeps what is sent, and fails as if there was a bug in it when it is asked for datagrams. */
  private static final class BrokenTransport implements RemoteTransport {
    private final BlockingQueue<byte[]> sent = new LinkedBlockingQueue<>();

    @Override
    public void send(byte[] frames) {
      sent.add(frames);
    }

    @Override
    public @Nullable RtpSession datagrams() {
      throw new NullPointerException("planted");
    }

    @Override
    public void close(String reason) {}

    @Override
    public void openDatagrams(RtpParameters terms) {}

    @Override
    public void closeDatagrams() {}

    @Override
    public void consumed(int bytes) {}

    @Override
    public void wantToRead() {}

    @Override
    public boolean read(ByteBuffer space) {
      return false;
    }

    @Override
    public void stopReading() {}

    @Override
    public void attended() {}

    /** The text of the next refusal; what else is sent is not looked at. */
    String refusal() throws InterruptedException {
      while (true) {
        byte[] frames = next(sent);
        for (int at = 0; at < frames.length; ) {
          int end = at + 4 + ByteBuffer.wrap(frames).getInt(at);
          WireInput in = new WireInput(frames, at + 4, end);
          if (in.octet() == Frame.REFUSAL) {
            in.size();
            return in.text();
          }
          at = end;
        }
      }
    }
  }

  private static <T> T next(BlockingQueue<T> queue) throws InterruptedException {
    T next = queue.poll(TestTimeout.LONG.toMillis(), TimeUnit.MILLISECONDS);
    assertTrue(next != null, "nothing has come");
    return next;
  }

  @BeforeEach
  void start() {
    System.setErr(new PrintStream(log, true, StandardCharsets.UTF_8));
    kernel = Kernel.builder().log(kernelLog::add).start();
    peer = kernel.connectRemote("arm", transport);
  }

  @AfterEach
  void end() {
    kernel.close();
    System.setErr(before);
  }

  private void ask(WireOutput frame) {
    peer.receive(frame.end().inside());
  }

  private static WireOutput frame(int type) {
    return new WireOutput(64).begin(type);
  }

  private void open(int id, String name) {
    ask(frame(Frame.OPEN).size(1).size(id).octet(0).text(name));
  }

  private String log() {
    return log.toString(StandardCharsets.UTF_8);
  }

  @Test
  void bugOfOursIsLoggedWithItsTrace() throws Exception {
    kernel.eval("var Global.x = 1");
    open(5, "Global.x");
    ask(frame(Frame.CLOSE).size(5));
    String told = next(kernelLog);
    assertTrue(told.endsWith("arm: internal error: java.lang.NullPointerException: planted"), told);
    assertTrue(log().contains("internal error in a request of a remote process"), this::log);
    assertTrue(log().contains("\tat " + BrokenTransport.class.getName() + ".datagrams"), this::log);
  }

  /** Otherwise a process could fill the log. */
  @Test
  void whatIsRefusedIsToldToTheProcessAlone() throws Exception {
    ask(frame(Frame.SYNC).size(2).size(77));
    assertEquals("no such variable: 77", transport.refusal());
    assertEquals("", log());
    assertTrue(kernelLog.isEmpty(), kernelLog::toString);
  }
}
