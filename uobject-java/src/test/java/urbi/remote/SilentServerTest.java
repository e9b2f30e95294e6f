package urbi.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import urbi.time.Stopwatch;
import urbi.wire.Protocol;

/**
 * A connection that is open, and says nothing any more: a machine that is off, a cable that is cut.
 */
class SilentServerTest {
  private final AtomicLong time = new AtomicLong(Long.MAX_VALUE - 1000);
  private final List<String> done = new ArrayList<>();

  private ConnectionMonitor watch() {
    return new ConnectionMonitor(
        new Stopwatch(time::get),
        () -> done.add("look"),
        () -> done.add("ask"),
        () -> done.add("give up"),
        defect -> done.add("defect"));
  }

  private boolean after(int seconds, ConnectionMonitor watch) {
    time.addAndGet(TimeUnit.SECONDS.toNanos(seconds));
    return watch.checkOnce();
  }

  @Test
  void silentPeerIsProbedAndThenDisconnected() {
    ConnectionMonitor watch = watch();
    assertTrue(after(Protocol.SILENCE_SECONDS - 1, watch));
    assertEquals(List.of("look"), done);
    assertTrue(after(1, watch));
    assertTrue(after(Protocol.TIMEOUT_SECONDS - Protocol.SILENCE_SECONDS - 1, watch));
    assertEquals(List.of("look", "look", "ask", "look", "ask"), done);
    assertFalse(after(1, watch));
    assertEquals("give up", done.getLast());
  }

  @Test
  void peerThatAnswersStaysConnected() {
    ConnectionMonitor watch = watch();
    for (int i = 0; i < 10; i++) {
      assertTrue(after(Protocol.TIMEOUT_SECONDS - 1, watch));
      watch.alive();
    }
    assertFalse(done.contains("give up"));
    watch.alive();
    assertTrue(after(1, watch));
    assertEquals("look", done.getLast());
  }

  @Test
  void endsTheContext() throws Exception {
    try (ServerSocket listener = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
      var connected =
          CompletableFuture.supplyAsync(() ->
              new RemoteContext("127.0.0.1", listener.getLocalPort(), new Stopwatch(time::get)));
      try (Socket socket = listener.accept()) {
        socket
            .getOutputStream()
            .write("[00000000:uobject] 1 test\n".getBytes(StandardCharsets.US_ASCII));
        RemoteContext context = connected.get();
        time.addAndGet(TimeUnit.SECONDS.toNanos(Protocol.TIMEOUT_SECONDS));
        assertEquals("the server does not answer any more", context.onClosed().get());
      }
    }
  }
}
