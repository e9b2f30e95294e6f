package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.tests.TestTimeout;

/** What the commands of a checkout say before they do anything. */
class CheckoutTest {
  private static final Path ROOT = Path.of("..").toAbsolutePath().normalize();

  /** Who may not write what belongs to somebody else, as root may. */
  private static final List<String> AS_NOBODY =
      List.of("/usr/bin/setpriv", "--reuid=65534", "--regid=65534", "--clear-groups");

  /** How a command has ended, and what it has said. */
  private record Answer(int status, String text) {}

  private static Answer answer(Path output, List<String> command) throws Exception {
    Process process =
        new ProcessBuilder(command)
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    try {
      boolean ended = process.waitFor(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS);
      String text = Files.readString(output, StandardCharsets.UTF_8);
      assertTrue(ended, () -> command + " has not ended: " + text);
      return new Answer(process.exitValue(), text);
    } finally {
      process.destroyForcibly();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"./check", "./build", "scripts/packages"})
  void helpDoesNothingElse(String command, @TempDir Path folder) throws Exception {
    String program = ROOT.resolve(command).toString();
    Answer help = answer(folder.resolve("help"), List.of(program, "--help"));
    assertEquals(0, help.status(), help::text);
    assertTrue(help.text().contains(command + "  "), help::text);
    assertFalse(help.text().contains("set -"), help::text);
    Answer wrong = answer(folder.resolve("wrong"), List.of(program, "--halp"));
    assertEquals(2, wrong.status(), wrong::text);
    assertTrue(wrong.text().contains("no such") && wrong.text().contains("--halp"), wrong::text);
    assertEquals(1, wrong.text().lines().count(), wrong::text);
  }

  @Test
  void anUnbuiltCloneThatMayNotBeWrittenSaysWhatToDo(@TempDir Path folder) throws Exception {
    Path clone = Files.createDirectory(folder.resolve("clone"));
    copy("urbi", clone);
    copy("build", clone);
    for (String script : List.of("launch.sh", "jdk.sh", "flags.sh")) {
      copy("scripts/" + script, clone);
    }
    List<String> command = new ArrayList<>();
    if (System.getProperty("user.name").equals("root")) {
      assumeTrue(Files.isExecutable(Path.of(AS_NOBODY.getFirst())), "skipped: no setpriv");
      command.addAll(AS_NOBODY);
    }
    command.addAll(List.of(clone.resolve("urbi").toString(), "--version"));
    Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxr-xr-x"));
    Files.setPosixFilePermissions(clone, PosixFilePermissions.fromString("r-xr-xr-x"));
    try {
      Answer answer = answer(folder.resolve("output"), command);
      assertEquals(1, answer.status(), answer::text);
      assertEquals(
          """
          urbi: nothing is built here yet, or not what is checked out, and %s cannot be written to:
          urbi: run ./build as who owns it, or clone it to where you may write
          """
              .formatted(clone.toRealPath()),
          answer.text());
    } finally {
      Files.setPosixFilePermissions(clone, PosixFilePermissions.fromString("rwxr-xr-x"));
    }
  }

  private static void copy(String file, Path clone) throws IOException {
    Path copy = clone.resolve(file);
    Files.createDirectories(copy.getParent());
    Files.copy(ROOT.resolve(file), copy);
    Files.setPosixFilePermissions(copy, PosixFilePermissions.fromString("rwxr-xr-x"));
  }
}
