package org.urbi.ros.one;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse.BodyHandlers;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.Executor;

/** Calls methods of masters and of other nodes. */
final class XmlRpcClient implements AutoCloseable {
  private static final Duration TIMEOUT = Duration.ofSeconds(5);

  private final HttpClient http;

  /**
   * @param threads where answers are read
   */
  XmlRpcClient(Executor threads) {
    http =
        HttpClient.newBuilder()
            .version(HttpClient.Version.HTTP_1_1)
            .connectTimeout(TIMEOUT)
            .proxy(HttpClient.Builder.NO_PROXY)
            .executor(threads)
            .build();
  }

  /**
   * Calls a method. Fails with an {@link IOException} if nobody answers within seconds.
   *
   * @throws IllegalArgumentException if the address is none
   */
  CompletableFuture<Object> call(URI server, String method, List<?> arguments) {
    HttpRequest request =
        HttpRequest.newBuilder(server)
            .timeout(TIMEOUT)
            .header("Content-Type", "text/xml")
            .POST(BodyPublishers.ofString(XmlRpcWriter.call(method, arguments)))
            .build();
    return http.sendAsync(request, BodyHandlers.ofByteArray())
        .thenApply(response -> {
          try {
            return XmlRpcReader.response(response.body());
          } catch (XmlRpcException e) {
            throw new CompletionException(e);
          }
        });
  }

  @Override
  public void close() {
    http.shutdownNow();
  }
}
