package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import urbi.UObject;

/**
 * The projects of {@code examples/eclipse}: compiled as Eclipse compiles them, run as their launch
 * configurations say, against a server.
 */
class EclipseProjectTest {
  private static final Path ROOT = Path.of("..").toAbsolutePath().normalize();

  @TempDir static Path folder;
  private static ServerProcess server;

  @BeforeAll
  static void start() throws Exception {
    server = ServerProcess.in(folder);
  }

  @AfterAll
  static void end() throws Exception {
    try (ServerProcess ending = server) {
      assertEquals(0, ending.shutDown(), ending::text);
    }
  }

  /** The classes that are in liburbijava.jar, which the build makes of them. */
  private static Path api() throws URISyntaxException {
    return Path.of(UObject.class.getProtectionDomain().getCodeSource().getLocation().toURI());
  }

  @ParameterizedTest
  @CsvSource({
    "uobjectjava, urbi.UMain",
    "uobjectjava_withmain, examples.uobjectjava_withmain.Main"
  })
  void itCompilesAndRuns(String name, String mainClass) throws Exception {
    Path original = ROOT.resolve("examples/eclipse").resolve(name);
    assertEquals(
        List.of(ROOT.resolve("share/sdk-remote/java/lib/liburbijava.jar")),
        new EclipseProject(original).libraries());

    EclipseProject project =
        new EclipseProject(EclipseProject.copy(original, folder.resolve(name)));
    assertEquals(name, project.name());
    assertEquals(name, project.launch("PROJECT_ATTR"));
    assertEquals(mainClass, project.launch("MAIN_TYPE"));
    assertEquals("", project.compile(List.of(api())));

    List<String> arguments = new ArrayList<>(project.programArguments());
    arguments.addAll(List.of("-H", "127.0.0.1", "-P", String.valueOf(server.port())));
    JavaProcess.Setting setting =
        JavaProcess.Setting.in(folder).withClassPath(project.classPath(List.of(api())));
    try (JavaProcess program = JavaProcess.start(setting, mainClass, arguments);
        ConsoleClient client = server.connect()) {
      program.awaitText("running on 127.0.0.1:" + server.port());
      Dialogue.read(original.resolve(name + ".u-session")).hold(client);
      program.terminate();
      program.awaitEnd();
    }
  }
}
