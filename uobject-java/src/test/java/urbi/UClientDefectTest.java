package urbi;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import urbi.thread.Awaited;
import urbi.thread.LoggedDefects;

/** An {@code Error} in a thread of a client: nobody waits for that thread for ever. */
class UClientDefectTest {
  private static void sendTwoMessages(Socket socket) throws IOException {
    String messages = "[00000001:a] \"one\"\n[00000002:a] \"two\"\n";
    socket.getOutputStream().write(messages.getBytes(StandardCharsets.US_ASCII));
  }

  private static ServerSocket listener() throws IOException {
    return new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
  }

  /** The first message meets a class that is not there, the second one is told all the same. */
  private static void breakFirstCallback(UClient client, Socket socket) throws Exception {
    var thrown = new CompletableFuture<Throwable>();
    var second = new CompletableFuture<String>();
    client.setCallback(
        message -> {
          if (!thrown.isDone()) {
            Thread.currentThread()
                .setUncaughtExceptionHandler((thread, failure) -> thrown.complete(failure));
            throw new NoClassDefFoundError("lost");
          }
          second.complete(message.getValue().stringValue());
          return UCallbackAction.URBI_CONTINUE;
        },
        "a");
    sendTwoMessages(socket);
    assertInstanceOf(NoClassDefFoundError.class, Awaited.value(thrown));
    assertEquals("two", Awaited.value(second));
    assertEquals(0, client.error());
    socket.close();
    Awaited.value(client.onClosed());
    assertEquals("the server has closed the connection", client.errorMessage());
  }

  @Test
  void inACallbackGoesToItsHandlerAndTheClientGoesOn() throws Exception {
    try (ServerSocket listener = listener()) {
      UClient plain = new UClient("127.0.0.1", listener.getLocalPort());
      breakFirstCallback(plain, listener.accept());
      UClient asking = new USyncClient("127.0.0.1", listener.getLocalPort());
      breakFirstCallback(asking, listener.accept());
    }
  }

  @Test
  void inTheReaderClosesTheClientAndIsSaid() throws Exception {
    try (ServerSocket listener = listener();
        var log = new LoggedDefects()) {
      UClient client =
          new UClient("127.0.0.1", listener.getLocalPort()) {
            @Override
            public void notifyCallbacks(UMessage message) {
              // What is thrown once more, when it is told of the end, is nothing to show.
              Thread.currentThread().setUncaughtExceptionHandler((thread, failure) -> {});
              throw new NoClassDefFoundError("lost");
            }
          };
      try (Socket socket = listener.accept()) {
        sendTwoMessages(socket);
        Awaited.value(client.onClosed());
        assertEquals(1, client.error());
        assertEquals("internal error: java.lang.NoClassDefFoundError: lost", client.errorMessage());
        assertTrue(
            log.texts()
                .contains(
                    "internal error in the thread urbi-client-reader"
                        + " <- java.lang.NoClassDefFoundError: lost"),
            () -> log.texts().toString());
      }
    }
  }

  @Test
  void inTheCheckOfTheServerIsTold() throws Exception {
    var told = new CompletableFuture<Throwable>();
    try (var log = new LoggedDefects()) {
      Runnable ask =
          () -> {
            throw new NoClassDefFoundError("lost");
          };
      new KeepAlive(0, 0, ask, () -> {}, told::complete);
      assertEquals("lost", Awaited.value(told).getMessage());
      assertEquals(1, log.texts().size());
    }
  }
}
