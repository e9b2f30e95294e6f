package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;

/** What {@code System.stats} says in simulated time depends on the program alone. */
class SimulatedStatisticsTest {
  private static final String PROGRAM = "sleep(2s); sleep(1s); System.stats;";

  @Test
  void cyclesInWhichNothingHappensDoNotCount() {
    assertEquals(statisticsAfter(0), statisticsAfter(3));
  }

  /** The kernel has been woken so often for nothing before the program comes. */
  private static String statisticsAfter(int cycles) {
    try (Kernel kernel = Kernel.builder().virtualTime(true).log(line -> {}).start()) {
      for (int i = 0; i < cycles; i++) {
        CompletableFuture<Void> woken = new CompletableFuture<>();
        KernelThread.run(kernel, () -> woken.complete(null));
        woken.join();
      }
      StringBuffer output = new StringBuffer();
      CompletableFuture<Void> closed = new CompletableFuture<>();
      Connection connection =
          kernel.connect(
              new Client() {
                @Override
                public void output(String bytes) {
                  output.append(bytes);
                }

                @Override
                public void closed() {
                  closed.complete(null);
                }
              });
      connection.send(PROGRAM);
      connection.end();
      closed.join();
      return output.toString();
    }
  }
}
