package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.trust.Role;

/**
 * Whatever a program does, the kernel survives it: random programs neither hang nor leave jobs
 * behind, nothing of Java shows, and they say the same twice.
 *
 * <p>The system properties {@code fuzz.seed} and {@code fuzz.seconds} choose the first seed and go
 * on with the next ones for so long; {@code scripts/fuzz} sets them.
 */
class ProgramFuzzTest {
  private static final long SEED = Long.getLong("fuzz.seed", 1);
  private static final long SECONDS = Long.getLong("fuzz.seconds", 0);

  /** So many batches are run when nobody says for how long; it takes a minute. */
  private static final int BATCHES = 40;

  /** So many defects are enough. */
  private static final int MOST = 20;

  /** One program, and one more in so many, may take too long. */
  private static final int RARE = 50;

  @TempDir private Path directory;

  @Test
  void whateverAProgramDoesTheKernelSurvivesIt() throws Exception {
    ProgramFuzzer fuzzer = new ProgramFuzzer(directory.toRealPath(), Role.USER);
    List<String> defects = new ArrayList<>();
    long begin = System.nanoTime();
    long seed = SEED;
    while (defects.size() < MOST
        && (SECONDS == 0
            ? seed < SEED + BATCHES
            : System.nanoTime() - begin < TimeUnit.SECONDS.toNanos(SECONDS))) {
      String defect = fuzzer.defect(seed++);
      if (defect != null) {
        defects.add(defect);
        if (SECONDS > 0) {
          System.out.println(defect + "\n");
        }
      }
    }
    if (SECONDS > 0) {
      System.out.println(
          fuzzer.programs()
              + " programs, "
              + fuzzer.interrupted()
              + " interrupted, "
              + fuzzer.exhausted()
              + " without memory, seeds "
              + SEED
              + " to "
              + (seed - 1)
              + ", "
              + defects.size()
              + " defects; "
              + TimeUnit.NANOSECONDS.toSeconds(System.nanoTime() - begin)
              + " s, CPU "
              + ManagementFactory.getPlatformMXBean(com.sun.management.OperatingSystemMXBean.class)
                      .getProcessCpuTime()
                  / 1_000_000_000
              + " s");
    }
    assertEquals("", String.join("\n\n", defects));
    assertTrue(fuzzer.interrupted() <= 1 + fuzzer.programs() / RARE, "too many never end");
  }
}
