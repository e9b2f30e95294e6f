package org.urbi.server.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.server.TestTimeout;
import org.urbi.server.tools.ToolResult;
import org.urbi.server.tools.UrbiSend;

/** The option {@code --socket}, by a program that is killed, and by its successor. */
class SocketCommandTest {
  @TempDir Path folder;

  private void awaitServer(Path file) throws InterruptedException {
    long end = System.nanoTime() + TestTimeout.LONG.toNanos();
    ToolResult answer;
    do {
      assertTrue(System.nanoTime() < end, "nobody answers");
      Thread.sleep(50);
      answer = ToolResult.of(UrbiSend::run, "-H", file.toString(), "-Q", "-e", "6*7;");
    } while (!answer.out().endsWith("] 42\n"));
  }

  @Test
  void theSuccessorOfAKilledServerTakesItsSocketAndRemovesIt()
      throws IOException, InterruptedException {
    Path file = folder.resolve("console");
    try (UrbiProcess urbi = new UrbiProcess(folder, Map.of(), "-q", "--socket", "console")) {
      awaitServer(file);
      urbi.kill();
    }
    assertTrue(Files.exists(file));
    try (UrbiProcess urbi =
        new UrbiProcess(
            folder, Map.of(), "-q", "--socket", "console", "--socket-permissions", "660")) {
      awaitServer(file);
      assertEquals(
          PosixFilePermissions.fromString("rw-rw----"), Files.getPosixFilePermissions(file));
      UrbiProcess.Result second = UrbiProcess.run(folder, "-q", "--socket", "console");
      assertEquals(1, second.status());
      assertTrue(second.err().contains("a server listens there already"), second.err());
      urbi.terminate();
      assertFalse(Files.exists(file));
    }
  }
}
