package org.urbi.bench.jmh;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.Kernel;
import urbi.UObject;

/**
 * A kernel in real time with one connection, on which a statement is sent and its value awaited.
 */
final class Session implements AutoCloseable {
  private static final int TIMEOUT_SECONDS = 60;

  private final Kernel kernel = Kernel.builder().start();
  private final BlockingQueue<String> output = new LinkedBlockingQueue<>();
  private final Connection connection =
      kernel.connect(
          new Client() {
            @Override
            public void output(String bytes) {
              output.add(bytes);
            }

            @Override
            public void closed() {
              output.add("!!! closed");
            }
          });

  /** Sends code whose last statement has a value, and the others have not. */
  String evaluate(String code) {
    connection.send(code);
    try {
      String answer = output.poll(TIMEOUT_SECONDS, TimeUnit.SECONDS);
      if (answer == null || answer.contains("!!!")) {
        throw new IllegalStateException(code + " gives " + answer);
      }
      return answer;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }

  /** Plugs in a UObject. */
  void start(Class<? extends UObject> type) {
    kernel.start(type);
  }

  /** Defines {@code turns(n)}, which does something so many times. */
  void defineTurns(String before, String body) {
    evaluate(
        before
            + "function turns(n) { var i = 0; while| (i < n) { "
            + body
            + " | i += 1 }; i }|;\n\"ready\";\n");
  }

  @Override
  public void close() {
    kernel.close();
  }
}
