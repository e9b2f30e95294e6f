package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Processes with {@code --fast} give the same output for the same input, including the numbers of
 * cycles.
 */
class FastRunTest {
  private static final int RUNS = 4;

  @TempDir private Path folder;

  @ParameterizedTest
  @ValueSource(strings = {"cycles.u", "spinning.u"})
  void processesSayTheSame(String name) throws Exception {
    Path program = Path.of("src", "test", "resources", "determinism", name).toAbsolutePath();
    Path ended = folder.resolve(name);
    Files.writeString(ended, Files.readString(program) + "\nshutdown;\n");
    List<JavaProcess> runs = new ArrayList<>();
    try {
      for (int i = 0; i < RUNS; i++) {
        // At the same time, so that each is kept waiting at other places.
        runs.add(
            JavaProcess.start(
                JavaProcess.Setting.in(folder),
                "org.urbi.server.cli.UrbiCommand",
                List.of("--fast", "-q", "-f", ended.toString())));
      }
      assertEquals(0, runs.getFirst().awaitEnd());
      String first = runs.getFirst().text();
      assertTrue(first.contains("cycle"), first);
      for (JavaProcess run : runs) {
        assertEquals(0, run.awaitEnd());
        assertEquals(first, run.text());
      }
    } finally {
      runs.forEach(JavaProcess::close);
    }
  }
}
