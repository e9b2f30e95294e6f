package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.trust.Role;

/**
 * Whoever listens to very many directories, and creates files there, does not fill the inbox of the
 * kernel, in which others wait.
 */
class WatchedDirectoriesTest {
  @TempDir Path directory;

  private final Kernel kernel = Kernel.builder().log(line -> {}).virtualTime(true).start();

  @AfterEach
  void close() {
    kernel.close();
  }

  private String watched() {
    return "Directory.new(\"" + directory + "\")";
  }

  @Test
  void aLobbyIsToldOnceOfAFileHoweverOftenItListens() throws IOException {
    TestClient client = new TestClient(kernel, Role.OWNER);
    client.say("var jobs = []|;");
    client.say(
        "function listen() { var d = "
            + watched()
            + " | at sync (d.fileCreated?) jobs << Job.current }|;");
    client.say("for (3) listen;");
    Files.createFile(directory.resolve("file"));
    String same = "jobs[0] === jobs[1] && jobs[1] === jobs[2];";
    assertEquals("true", client.say("waituntil (jobs.size == 3); " + same));
  }

  @Test
  void aSubscriptionAfterAllHaveEndedWatchesAnew() throws IOException {
    TestClient client = new TestClient(kernel, Role.OWNER);
    client.say("var d = " + watched() + "|; var other = " + watched() + "|; var t = Tag.new|;");
    client.say("t: at (d.fileCreated?) {}; t.stop; at (other.fileCreated?) lobby.send(\"other\");");
    Files.createFile(directory.resolve("one"));
    assertTrue(client.next().contains("other"));
    client.say("at (d.fileDeleted?(var name)) lobby.send(name);");
    Files.delete(directory.resolve("one"));
    assertTrue(client.next().contains("one"));
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void whatNobodyListensToIsWatchedNoLonger() throws IOException {
    TestClient judge = new TestClient(kernel, Role.OWNER);
    TestClient client = new TestClient(kernel, Role.OWNER);
    client.say("var d = " + watched() + "|; at (d.fileCreated?) {};");
    assertTrue(isWatched());
    client.connection().close();
    for (int i = 0; isWatched(); i++) {
      Files.createFile(directory.resolve("file" + i));
      judge.say("1;");
    }
  }

  /** Whether the system watches the directory for this process: proc_pid_fdinfo(5). */
  private boolean isWatched() throws IOException {
    String watch =
        "ino:" + Long.toHexString((long) Files.getAttribute(directory, "unix:ino")) + " ";
    try (Stream<Path> open = Files.list(Path.of("/proc/self/fdinfo"))) {
      return open.toList().stream()
          .flatMap(each -> lines(each).stream())
          .anyMatch(line -> line.contains(watch));
    }
  }

  private static List<String> lines(Path file) {
    try {
      return Files.readAllLines(file);
    } catch (IOException e) {
      // It has been closed meanwhile.
      return List.of();
    }
  }
}
