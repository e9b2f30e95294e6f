package org.urbi.server.studio;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;

/** The end of a stream from the studio's port, and the texts that it has heard. */
class StreamClient implements WebSocket.Listener, AutoCloseable {
  /** For how long something is awaited, in nanoseconds. */
  private static final long LIMIT = TimeUnit.SECONDS.toNanos(60);

  final LinkedBlockingQueue<String> heard = new LinkedBlockingQueue<>();
  final WebSocket socket;
  volatile int status;
  volatile String reason = "";
  private final StringBuilder part = new StringBuilder();

  /**
   * @param path what is asked for, behind the port
   * @param subprotocols those that are offered
   */
  StreamClient(StudioServer studio, String path, String... subprotocols) {
    WebSocket.Builder builder = HttpClient.newHttpClient().newWebSocketBuilder();
    if (subprotocols.length > 0) {
      builder.subprotocols(subprotocols[0]);
    }
    socket = builder.buildAsync(URI.create("ws://localhost:" + studio.port() + path), this).join();
  }

  @Override
  public CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
    part.append(data);
    if (last) {
      heard.add(part.toString());
      part.setLength(0);
    }
    from.request(1);
    return null;
  }

  @Override
  public CompletionStage<?> onClose(WebSocket from, int code, String reason) {
    status = code;
    this.reason = reason;
    heard.add("closed");
    return null;
  }

  @Override
  public void onError(WebSocket from, Throwable error) {
    heard.add("closed");
  }

  void send(String text) {
    socket.sendText(text, true).join();
  }

  String await(Predicate<String> wanted) throws InterruptedException {
    List<String> others = new ArrayList<>();
    long deadline = System.nanoTime() + LIMIT;
    while (true) {
      String message = heard.poll(deadline - System.nanoTime(), TimeUnit.NANOSECONDS);
      assertNotNull(message, () -> "in vain; it has heard:\n" + String.join("\n", others));
      if (wanted.test(message)) {
        return message;
      }
      others.add(message);
      assertFalse(message.equals("closed"), () -> "closed after:\n" + String.join("\n", others));
    }
  }

  String await(String part) throws InterruptedException {
    return await(message -> message.contains(part));
  }

  @Override
  public void close() {
    socket.abort();
  }
}
