package org.urbi.server.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** With which start-up cache the launchers start Java; here Java only says how it was started. */
class StartUpCacheTest {
  private static final FileTime BEFORE = FileTime.from(Instant.parse("2026-01-01T00:00:00Z"));
  private static final FileTime THEN = FileTime.from(Instant.parse("2026-01-01T00:00:01Z"));
  private static final FileTime LATER = FileTime.from(Instant.parse("2026-01-01T00:00:02Z"));

  @TempDir private Path root;
  private Path jar;
  private Path cache;

  @BeforeEach
  void distribution() throws IOException {
    Path java = Files.createDirectories(root.resolve("runtime/bin")).resolve("java");
    Files.writeString(java, "#!/bin/sh\nprintf '%s\\n' \"$@\"\n");
    assertTrue(java.toFile().setExecutable(true));
    jar = Files.createFile(Files.createDirectories(root.resolve("dist/lib")).resolve("urbi.jar"));
    Files.setLastModifiedTime(jar, BEFORE);
    cache = Files.createFile(root.resolve("dist/urbi.aot"));
    Files.setLastModifiedTime(cache, THEN);
    Path scripts = Files.createDirectory(root.resolve("scripts"));
    for (String name : new String[] {"flags.sh", "launch.sh"}) {
      Files.copy(Path.of("..", "scripts", name), scripts.resolve(name));
    }
  }

  private String started() throws IOException, InterruptedException {
    Process shell =
        new ProcessBuilder("/bin/sh", "-ec", "root=$PWD main=Main; . ./scripts/launch.sh")
            .redirectErrorStream(true)
            .directory(root.toFile())
            .start();
    String text = new String(shell.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, shell.waitFor(), text);
    return text;
  }

  @Test
  void theCacheOfTheDistributionIsUsed() throws IOException, InterruptedException {
    String said = started();
    assertTrue(said.contains("-XX:AOTCache=" + cache.toRealPath() + "\n"), said);
    assertFalse(said.contains("urbi: "), said);
  }

  @Test
  void aJarThatWasReplacedIsNotRunFromTheCache() throws IOException, InterruptedException {
    Files.setLastModifiedTime(jar, LATER);
    String said = started();
    assertTrue(said.startsWith("urbi: " + jar.toRealPath() + " is newer than the start-up cache"));
    assertFalse(said.contains("AOT"), said);
  }

  @Test
  void withoutCacheJavaStartsAllTheSame() throws IOException, InterruptedException {
    Files.delete(cache);
    String said = started();
    assertFalse(said.contains("AOT") || said.contains("urbi: "), said);
    assertTrue(said.contains("\nMain\n"), said);
  }
}
