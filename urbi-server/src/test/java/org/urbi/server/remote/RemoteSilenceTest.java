package org.urbi.server.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.urbi.kernel.Kernel;
import org.urbi.server.Trace;
import org.urbi.server.net.ConsoleServer;
import org.urbi.server.net.Limits;
import urbi.remote.RemoteContext;
import urbi.wire.Protocol;

/**
 * A connection that is open, and says nothing any more: a machine that is off, a cable that is cut.
 */
@Timeout(60)
class RemoteSilenceTest {
  private static final String HOST = "127.0.0.1";

  /** Connects, agrees, and never says anything again; how long until the server hangs up. */
  private static double silentProcess(int port) throws IOException {
    try (Socket socket = new Socket(HOST, port)) {
      socket.getOutputStream().write(Protocol.request().getBytes(StandardCharsets.US_ASCII));
      long start = System.nanoTime();
      InputStream in = socket.getInputStream();
      in.transferTo(OutputStream.nullOutputStream());
      return (System.nanoTime() - start) / 1e9;
    }
  }

  /** Agrees, and never says anything again. */
  private static String silentServer() throws Exception {
    try (ServerSocket listener = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
      var context =
          CompletableFuture.supplyAsync(() -> new RemoteContext(HOST, listener.getLocalPort()));
      try (Socket socket = listener.accept()) {
        socket
            .getOutputStream()
            .write("[00000000:uobject] 1 test\n".getBytes(StandardCharsets.US_ASCII));
        return context.get(20, TimeUnit.SECONDS).onClosed().get(40, TimeUnit.SECONDS);
      }
    }
  }

  @Test
  void isNoticedByBothSides() throws Exception {
    PrintStream nowhere =
        new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
    try (Kernel kernel = Kernel.builder().start();
        ConsoleServer server =
            new ConsoleServer(
                new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
                each -> kernel.connect(each, false),
                kernel::connectRemote,
                Limits.DEFAULT,
                new Trace(Trace.Level.NONE, nowhere))) {
      CompletableFuture<Double> seconds =
          CompletableFuture.supplyAsync(() -> {
            try {
              return silentProcess(server.port());
            } catch (IOException e) {
              throw new IllegalStateException(e);
            }
          });
      try (RemoteContext living = new RemoteContext(HOST, server.port())) {
        assertEquals("the server does not answer any more", silentServer());
        double silence = seconds.get(40, TimeUnit.SECONDS);
        assertTrue(silence >= 10 && silence <= 30, silence + " s");
        assertTrue(!living.onClosed().isDone(), "one that answers is not given up");
      }
    }
  }
}
