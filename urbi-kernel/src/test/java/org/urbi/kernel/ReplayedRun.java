package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertNull;

import java.nio.file.Path;
import java.util.function.Consumer;
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

  /** What a kernel in simulated time shows, whose run is recorded. */
  public static String recorded(Path recording, Consumer<Kernel> program) {
    StringBuffer shown = new StringBuffer();
    try (Kernel kernel =
        Kernel.builder().virtualTime(true).output(shown::append).record(recording).start()) {
      program.accept(kernel);
    }
    return shown.toString();
  }

  /** What the replay shows, which must end, and do what was recorded. */
  public static String replayed(Path recording) {
    StringBuffer shown = new StringBuffer();
    assertNull(difference(Kernel.builder().output(shown::append), recording));
    return shown.toString();
  }

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
    return ended(builder, recording).replayDifference();
  }

  /** A kernel that has replayed the run, to its end. */
  static Kernel ended(KernelBuilder builder, Path recording) {
    Kernel replayed = builder.log(line -> {}).replay(recording, number -> SILENT).start();
    replayed.awaitTermination();
    return replayed;
  }
}
