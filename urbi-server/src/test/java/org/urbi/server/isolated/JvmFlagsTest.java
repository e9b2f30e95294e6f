package org.urbi.server.isolated;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The flags that the launchers give to JVMs, and what a user adds to them. */
class JvmFlagsTest {
  private static final String SERIAL = "-XX:+UseSerialGC";

  /** What is left of the flags of the launchers when a user has set URBI_JAVA_OPTS. */
  private static List<String> ofLauncher(String options) throws IOException, InterruptedException {
    return said(options, ". ./flags.sh; printf '%s\\n' $jvm_flags");
  }

  private static List<String> said(String options, String script)
      throws IOException, InterruptedException {
    ProcessBuilder shell =
        new ProcessBuilder("/bin/sh", "-euc", script)
            .directory(Path.of("..", "scripts").toFile())
            .redirectErrorStream(true);
    shell.environment().put("URBI_JAVA_OPTS", options);
    Process process = shell.start();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), text);
    return text.lines().toList();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"-XX:+UseZGC", "-Xmx64m -XX:+UseG1GC -Da=b", SERIAL, "-XX:+UseParallelGC", ""})
  void aJvmStartsWithWhatTheUserAdds(String options) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(ofLauncher(options));
    Arrays.stream(options.split(" ")).filter(word -> !word.isEmpty()).forEach(command::add);
    command.add("-version");
    Process java = new ProcessBuilder(command).redirectErrorStream(true).start();
    String text = new String(java.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, java.waitFor(), text);
  }

  @Test
  void ourCollectorIsThereUnlessTheUserHasOne() throws IOException, InterruptedException {
    assertTrue(ofLauncher("").contains(SERIAL));
    assertTrue(ofLauncher("-XX:+UseGCOverheadLimit -XX:ZCollectionInterval=5").contains(SERIAL));
    assertFalse(ofLauncher("-Xmx1g -XX:+UseShenandoahGC").contains(SERIAL));
  }

  /** That of a server. */
  @Test
  void theCollectorOfALauncherIsThereUnlessTheUserHasOne()
      throws IOException, InterruptedException {
    String server = "collector=-XX:+UseG1GC; . ./flags.sh; echo $collector";
    assertEquals(List.of("-XX:+UseG1GC"), said("-Xmx1g", server));
    assertEquals(List.of(""), said("-XX:+UseZGC", server));
  }

  @Test
  void aModulesProcessHasTheCollectorOfTheKernelAndNotItsMemory() {
    assertEquals(
        List.of(
            "--add-opens=java.base/java.lang=ALL-UNNAMED",
            "-XX:+UseCompactObjectHeaders",
            "-XX:-UsePerfData",
            "-XX:-ProfileExceptionHandlers",
            "-Xlog:disable",
            "-XX:+UseZGC"),
        JvmFlags.common(
            List.of(
                "--add-opens=java.base/java.lang=ALL-UNNAMED",
                "-XX:+UseCompactObjectHeaders",
                "-XX:-UsePerfData",
                "-XX:-ProfileExceptionHandlers",
                "-Xlog:disable",
                "-XX:AOTCache=urbi.aot",
                "-Xmx8g",
                "-agentlib:jdwp=transport=dt_socket,server=y,address=5005",
                "-XX:+UseZGC",
                "-Durbi.root=/urbi")));
  }

  /** The form in which a JVM tells its own flags is its business. */
  @Test
  void thisJvmTellsItsFlagsInThatForm() {
    assertTrue(
        JvmFlags.inherited().contains("--add-opens=java.base/java.lang=ALL-UNNAMED"),
        JvmFlags.inherited()::toString);
  }
}
