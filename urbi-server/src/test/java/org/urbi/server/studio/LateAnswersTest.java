package org.urbi.server.studio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.lang.reflect.Proxy;
import java.nio.file.Path;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.Kernel;
import org.urbi.server.studio.files.Folders;
import org.urbi.server.trust.AccessPolicy;

/**
 * Defects of the kernel, and of what is done with its answers: they end the stream they concern.
 */
class LateAnswersTest {
  private static final Map<String, CompletableFuture<?>> WRONG = new HashMap<>();
  private static final String COMPLETE = "{\"type\":\"complete\",\"id\":1,\"text\":\"ec\"}";

  @TempDir static Path folder;
  private static Kernel kernel;
  private static StudioServer studio;

  private static final Logger LOGGER = Logger.getLogger("urbi.web");
  private static final Queue<LogRecord> LOGGED = new ConcurrentLinkedQueue<>();

  @BeforeAll
  static void start() throws Exception {
    LOGGER.setUseParentHandlers(false);
    LOGGER.setFilter(record -> !LOGGED.add(record));
    kernel = Kernel.builder().log(line -> {}).start();
    studio =
        Served.of(
            kernel,
            LateAnswersTest::connect,
            AccessPolicy.ALL,
            Shown.VARIABLES,
            new Folders(folder, null),
            new RecordedFiles());
  }

  /** A connection of a kernel of which some functions answer what is wrong. */
  private static Connection connect(Client client) {
    Connection real = kernel.connect(client, false);
    Map<String, CompletableFuture<?>> wrong = Map.copyOf(WRONG);
    return (Connection)
        Proxy.newProxyInstance(
            Connection.class.getClassLoader(),
            new Class<?>[] {Connection.class},
            (proxy, method, arguments) ->
                wrong.containsKey(method.getName())
                    ? wrong.get(method.getName())
                    : method.invoke(real, arguments));
  }

  @AfterEach
  void heal() {
    WRONG.clear();
    LOGGED.clear();
  }

  @AfterAll
  static void stop() {
    studio.close();
    kernel.close();
    LOGGER.setUseParentHandlers(true);
    LOGGER.setFilter(null);
  }

  private static StreamClient page() {
    return new StreamClient(studio, "/stream");
  }

  private static StreamClient program() {
    return new StreamClient(studio, "/", "foxglove.websocket.v1");
  }

  private static void assertEndsAsADefect(StreamClient stream) throws InterruptedException {
    stream.await("closed"::equals);
    assertEquals("1011 internal error", stream.status + " " + stream.reason);
    LogRecord record = LOGGED.remove();
    assertEquals("internal error in the studio", record.getMessage());
    assertNotNull(record.getThrown());
  }

  private static <T> CompletableFuture<T> defect() {
    return CompletableFuture.failedFuture(new IllegalStateException("a defect of the test"));
  }

  @Test
  void answerThatCannotBeToldEndsTheStream() throws Exception {
    try (StreamClient other = page()) {
      // It has a connection then, of which nothing is wrong.
      other.await("\"view\"");
      WRONG.put("propose", CompletableFuture.completedFuture(Collections.singletonList(null)));
      WRONG.put("values", CompletableFuture.completedFuture(List.of()));
      try (StreamClient page = page();
          StreamClient program = program()) {
        page.await("\"hello\"");
        page.send(COMPLETE);
        assertEndsAsADefect(page);
        program.send("{\"op\":\"getParameters\",\"parameterNames\":[\"a.b\"],\"id\":\"a\"}");
        assertEndsAsADefect(program);
      }
      other.send(COMPLETE);
      other.await("\"echo\"");
    }
  }

  @Test
  void questionAtWhichTheKernelFailsEndsTheStream() throws Exception {
    WRONG.put("look", defect());
    try (StreamClient page = page()) {
      assertEndsAsADefect(page);
    }
    WRONG.put("look", CompletableFuture.completedFuture(null));
    WRONG.put("sample", defect());
    try (StreamClient page = page()) {
      page.await("\"hello\"");
      page.send("{\"type\":\"plot\",\"id\":1,\"ways\":[\"Global\\na\"]}");
      assertEndsAsADefect(page);
    }
  }

  @Test
  void connectionThatTheKernelClosesIsNoDefect() throws Exception {
    CompletableFuture<List<?>> closed = new CompletableFuture<>();
    closed.cancel(false);
    WRONG.put("propose", closed);
    WRONG.put("values", closed.thenApply(List::size));
    try (StreamClient page = page();
        StreamClient program = program()) {
      page.send(COMPLETE);
      page.send("nonsense");
      page.await("\"error\"");
      program.send("{\"op\":\"getParameters\",\"parameterNames\":[\"a.b\"],\"id\":\"a\"}");
      program.send("nonsense");
      program.await("no JSON");
    }
    assertEquals(0, LOGGED.size());
  }
}
