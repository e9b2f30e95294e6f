package org.urbi.kernel.outside;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.KernelBuilder;
import org.urbi.kernel.ReplayedRun;

/** A disk that is slow, or full, concerns the job that writes, and nobody else. */
class FileSinkTest {
  @TempDir Path folder;

  private String written(KernelBuilder builder, String program) {
    StringBuffer shown = new StringBuffer();
    try (Kernel kernel = builder.virtualTime(true).output(shown::append).start()) {
      kernel.eval(
          "{ var os = OutputStream.new(File.create(\"" + file() + "\"));" + program + " };");
    }
    return shown.toString();
  }

  private Path file() {
    return folder.resolve("file");
  }

  private static final String MUCH =
      """
      var over = false;
      var turns = 0;
      { os << "a" * 20000000 | over = true } & { while (!over) turns += 1 };
      echo(turns > 0);
      os.close\
      """;

  @Test
  void othersRunWhileMuchIsWritten() throws IOException {
    String shown = written(Kernel.builder(), MUCH);
    assertTrue(shown.endsWith("*** true\n"), shown);
    assertEquals(20_000_000, Files.size(file()));
  }

  @Test
  void whatIsWrittenMeanwhileComesAfterIt() throws IOException {
    written(
        Kernel.builder(),
        """
        { os << "a" * 1000000 } & { os << "b" * 1000000 } & { os << "c" | os.flush };
        os.close\
        """);
    assertEquals("a".repeat(1_000_000) + "b".repeat(1_000_000) + "c", Files.readString(file()));
  }

  @Test
  void aReplayWritesNothing() throws IOException {
    Path recording = folder.resolve("run");
    written(Kernel.builder().record(recording), MUCH);
    Files.delete(file());
    ReplayedRun.check(recording);
    assertFalse(Files.exists(file()));
  }
}
