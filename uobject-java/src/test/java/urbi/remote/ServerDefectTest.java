package urbi.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import urbi.thread.Awaited;
import urbi.thread.LoggedDefects;
import urbi.wire.Frame;
import urbi.wire.WireOutput;

/** An {@code Error} in the process of a component while it reads what the kernel sends. */
class ServerDefectTest {
  private static void send(Socket socket, Consumer<WireOutput> frames) throws Exception {
    WireOutput out = new WireOutput(64);
    frames.accept(out);
    socket.getOutputStream().write(out.array(), 0, out.length());
  }

  @Test
  void ofAListenerIsItsOwnAndOfTheReaderEndsTheConnection() throws Exception {
    try (ServerSocket listener = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
        var log = new LoggedDefects()) {
      var connected =
          CompletableFuture.supplyAsync(
              () -> new RemoteContext("127.0.0.1", listener.getLocalPort()));
      try (Socket socket = listener.accept()) {
        OutputStream out = socket.getOutputStream();
        out.write("[00000000:uobject] 1 test\n".getBytes(StandardCharsets.US_ASCII));
        RemoteContext context = Awaited.value(connected);
        var shown = new CompletableFuture<String>();
        context.onOutput(text -> {
          throw new NoClassDefFoundError("of a listener");
        });
        context.onOutput(text -> shown.complete(new String(text, StandardCharsets.US_ASCII)));
        send(socket, frames -> frames.begin(Frame.OUTPUT).bytes(new byte[] {'x'}, 0, 1).end());
        assertEquals("x", Awaited.value(shown));
        context.trace(text -> {
          throw new NoClassDefFoundError("of ours");
        });
        send(socket, frames -> frames.begin(Frame.CALL).size(1).text("a").text("b").values().end());
        assertEquals(
            "internal error: java.lang.NoClassDefFoundError: of ours",
            Awaited.value(context.onClosed()));
        String logged = log.texts().toString();
        assertTrue(logged.contains("NoClassDefFoundError: of a listener\n\tat "), logged);
        assertTrue(logged.contains("internal error in reading what the server has sent"), logged);
      }
    }
  }
}
