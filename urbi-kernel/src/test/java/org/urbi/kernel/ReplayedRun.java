package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertNull;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/** A run that is had again from its recording, without its clients. */
public final class ReplayedRun {
  /** Whoever was connected in the run that is replayed. */
  private static final Client SILENT =
      new Client() {
        @Override
        public void output(String bytes) {}

        @Override
        public void closed() {}
      };

  private ReplayedRun() {}

  /** The replay must end, and do what was recorded. */
  public static void check(Path recording) {
    assertNull(difference(recording));
  }

  /** How the replay, which must end, differs from what was recorded; null if it does not. */
  static @Nullable String difference(Path recording) {
    return difference(Kernel.builder(), recording);
  }

  /** The same, in a kernel that tells somebody what it shows. */
  public static @Nullable String difference(KernelBuilder builder, Path recording) {
    Kernel replayed = builder.log(line -> {}).replay(recording, number -> SILENT).start();
    replayed.awaitTermination();
    return replayed.replayDifference();
  }
}
