package org.urbi.server.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.time.SystemClock;
import org.urbi.server.TestTimeout;

class WatchdogTest {
  private final ByteArrayOutputStream told = new ByteArrayOutputStream();
  private final CompletableFuture<Integer> end = new CompletableFuture<>();

  private Watchdog watchdog(Kernel kernel, long silence, Duration limit) {
    Watchdog watchdog =
        new Watchdog(
            new SystemClock(),
            kernel,
            () -> silence,
            limit,
            new PrintStream(told, true, StandardCharsets.UTF_8),
            end::complete);
    watchdog.start();
    return watchdog;
  }

  private int status() throws Exception {
    return end.get(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS);
  }

  @Test
  void blockedNetworkThreadEndsTheProcess() throws Exception {
    try (Kernel kernel = Kernel.builder().start()) {
      Watchdog watchdog = watchdog(kernel, 90_000_000_000L, Duration.ofSeconds(60));
      assertEquals(ExitStatus.STUCK, status());
      watchdog.stop();
      assertTrue(
          told.toString(StandardCharsets.UTF_8)
              .startsWith("urbi: the network has not turned for 90.0 s\nurbi: giving up\n"));
    }
  }

  /**
   * A server may let jobs hold it as long as they like; its supervisor hears of it all the same.
   */
  @Test
  void jobThatMayHoldTheKernelEndsTheProcessAllTheSame() throws Exception {
    try (Kernel kernel = Kernel.builder().start()) {
      kernel.embedding().define("over", none -> end.isDone());
      Watchdog watchdog = watchdog(kernel, 0, Duration.ofMillis(100));
      kernel.embedding().evalAsync("while| (!over()) {};");
      assertEquals(ExitStatus.STUCK, status());
      watchdog.stop();
      String text = told.toString(StandardCharsets.UTF_8);
      assertTrue(text.contains("urbi: the kernel has been held for "), text);
    }
  }

  @Test
  void processThatIgnoresTerminationIsEnded() throws Exception {
    try (Kernel kernel = Kernel.builder().start()) {
      Watchdog watchdog = watchdog(kernel, 0, Duration.ZERO);
      watchdog.terminating();
      assertEquals(ExitStatus.TERMINATED, status());
      watchdog.stop();
    }
  }

  /** What comes after its last kernel may never end either. */
  @Test
  void processThatIsTerminatedIsWatchedUntilItIsGone() throws Exception {
    try (Kernel kernel = Kernel.builder().start()) {
      Watchdog watchdog = watchdog(kernel, 0, Duration.ZERO);
      watchdog.terminating();
      watchdog.stop();
      assertEquals(ExitStatus.TERMINATED, status());
    }
  }
}
