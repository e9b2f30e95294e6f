package org.urbi.server.studio;

import static org.junit.jupiter.api.Assertions.assertFalse;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Predicate;

/** The end of a stream from the studio's port, and the texts that it has heard. */
class StreamClient implements WebSocket.Listener, AutoCloseable {
  final LinkedBlockingQueue<String> heard = new LinkedBlockingQueue<>();
  final WebSocket socket;
  volatile int status;
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
    while (true) {
      String message = heard.take();
      if (wanted.test(message)) {
        return message;
      }
      assertFalse(message.equals("closed"), "closed before it came");
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
