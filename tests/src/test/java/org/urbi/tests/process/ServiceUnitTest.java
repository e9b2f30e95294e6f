package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The unit for systemd: that it is one, and that urbi knows its command line. What it does is tried
 * with the packages, by {@code scripts/package/systemd.sh}.
 */
class ServiceUnitTest {
  private static final Path UNIT = Path.of("../share/systemd/urbi.service");
  private static final Path ANALYZE = Path.of("/usr/bin/systemd-analyze");
  private static final String PROGRAM = "/usr/bin/urbi ";

  @TempDir Path folder;
  private String unit;
  private String command;

  @BeforeEach
  void read() throws Exception {
    unit = Files.readString(UNIT);
    command = value("ExecStart");
    assertTrue(command.startsWith(PROGRAM), command);
  }

  private String value(String setting) {
    List<String> found = unit.lines().filter(line -> line.startsWith(setting + "=")).toList();
    assertEquals(1, found.size(), setting);
    return found.getFirst().substring(setting.length() + 1);
  }

  @Test
  void systemdUnderstandsIt() throws Exception {
    assumeTrue(Files.isExecutable(ANALYZE), "skipped: no systemd-analyze");
    Path program = Files.createFile(folder.resolve("urbi"));
    Files.setPosixFilePermissions(program, PosixFilePermissions.fromString("rwxr-xr-x"));
    Path copy = folder.resolve("urbi.service");
    Files.writeString(copy, unit.replace(PROGRAM, program + " "));
    Process process =
        new ProcessBuilder(ANALYZE.toString(), "verify", "--man=no", copy.toString())
            .redirectErrorStream(true)
            .start();
    process.getOutputStream().close();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), text);
    assertEquals("", text);
  }

  /** The rest is the same, but for the port, the program and the end of it. */
  @Test
  void urbiUnderstandsItsCommandLine() throws Exception {
    Path program = Files.writeString(folder.resolve("robot.u"), "shutdown;");
    String[] words =
        command
            .substring(PROGRAM.length())
            .replace("54000", "0")
            .replace("/etc/urbi/robot.u", program.toString())
            .split(" ");
    assertTrue(Arrays.asList(words).contains(program.toString()), command);
    try (JavaProcess urbi =
        JavaProcess.start(
            JavaProcess.Setting.in(folder), "org.urbi.server.cli.UrbiCommand", List.of(words))) {
      assertEquals(0, urbi.awaitEnd(), urbi::text);
    }
  }

  /**
   * Whoever did not turn any more (70) or had no memory (71) is restarted, misuse (1, 2) is not.
   */
  @Test
  void onlyMistakesOfItsUserAreFinal() {
    assertEquals("1 2", value("RestartPreventExitStatus"));
    assertEquals("143", value("SuccessExitStatus"));
  }
}
