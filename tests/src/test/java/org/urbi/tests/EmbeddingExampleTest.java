package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The example of {@code examples/embedding} does what its README says. */
class EmbeddingExampleTest {
  private static final Path EXAMPLE = Path.of("..", "examples", "embedding");
  private static final String OPEN = "--add-opens=java.base/java.lang=ALL-UNNAMED";

  @TempDir Path folder;

  @Test
  void itRunsWithTheFlag() throws Exception {
    assertEquals(promised(), run(OPEN));
  }

  @Test
  void itRunsWithoutTheFlag() throws Exception {
    assertEquals(promised(), run());
  }

  /** The indented block that follows "It prints". */
  private static String promised() throws Exception {
    StringBuilder text = new StringBuilder();
    boolean found = false;
    for (String line : Files.readAllLines(EXAMPLE.resolve("README.md"), StandardCharsets.UTF_8)) {
      if (found && line.startsWith("    ")) {
        text.append(line.substring(4)).append('\n');
      } else if (!text.isEmpty()) {
        break;
      }
      found |= line.equals("It prints");
    }
    return text.toString();
  }

  /** Surefire hides the class path of the tests in a jar. */
  private static String classPath() {
    return System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
  }

  private String run(String... options) throws Exception {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    StringWriter messages = new StringWriter();
    boolean compiled;
    try (var files = compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8)) {
      compiled =
          compiler
              .getTask(
                  messages,
                  files,
                  null,
                  List.of("-proc:none", "-Werror", "-cp", classPath(), "-d", folder.toString()),
                  null,
                  files.getJavaFileObjects(EXAMPLE.resolve("Embed.java")))
              .call();
    }
    assertTrue(compiled, messages.toString());

    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1"));
    command.addAll(List.of(options));
    command.addAll(List.of("-cp", folder + File.pathSeparator + classPath(), "Embed"));
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    process.getOutputStream().close();
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), output);
    return output;
  }
}
