package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertNull;

import java.nio.file.Path;

/** A run that is had again from its recording, without its clients. */
final class ReplayedRun {
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
  static void check(Path recording) {
    Kernel replayed = Kernel.builder().log(line -> {}).replay(recording, number -> SILENT).start();
    replayed.awaitTermination();
    assertNull(replayed.replayDifference());
  }
}
