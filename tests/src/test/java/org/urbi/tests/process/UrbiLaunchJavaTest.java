package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.spi.ToolProvider;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.tests.FreePorts;
import org.urbi.tests.process.JavaProcess.Setting;
import urbi.UObject;

/** The command lines of the manual's chapters 3 and 5, as they are printed there. */
class UrbiLaunchJavaTest {
  private static final String LAUNCH = "org.urbi.server.launch.UrbiLaunchJava";
  private static final Path MACHINE = Modules.SOURCES.resolve("machine.uob");

  private static final String THROWER =
      """
      public class Thrower extends urbi.UObject {
        static { UStart(Thrower.class); }

        public Thrower(String name) {
          super(name);
          throw new IllegalStateException("no device");
        }
      }
      """;

  private static final String CLASSIC_MAIN =
      """
      import liburbi.main.*;

      public class Main {
        static {
          System.loadLibrary("urbijava");
        }

        public static void main(String[] argv) {
          UObject.UStart(UMachine.class);
          UObject.main(argv);
        }
      }
      """;

  @TempDir static Path built;
  private static Modules modules;

  @TempDir Path folder;
  private Setting here;

  @BeforeAll
  static void makeModules() {
    modules = new Modules(built);
  }

  @BeforeEach
  void set() {
    here = Setting.in(folder);
  }

  private void copy(String module) throws IOException {
    Files.copy(modules.jar(module), folder.resolve(module + ".jar"));
  }

  private Launch program() {
    return new Launch(here, LAUNCH);
  }

  private JavaProcess launch(String... arguments) throws IOException {
    return program().start(arguments);
  }

  private void failsToLaunch(String message, String... arguments) throws Exception {
    program().fails(1, message, arguments);
  }

  // ------------------------------------------------------------------ plugged

  @Test
  void aServerIsStartedWithItsModuleAndASession() throws Exception {
    copy("machine");
    try (JavaProcess urbi = launch("--start", "machine.jar", "--", "--interactive")) {
      urbi.awaitText("Urbi");
      urbi.send("var f = UMachine.new(10ms);\n");
      urbi.awaitLine(line -> Launch.plain(line).equals("[] UMachine_0x"));
      urbi.send("f.assemble([\"Hello, \", \"World!\"]);\n");
      urbi.awaitLine(line -> Launch.plain(line).equals("[] \"Hello, World!\""));
      urbi.send("shutdown;\n");
      assertEquals(0, urbi.awaitEnd(), urbi::text);
    }
  }

  @Test
  void aServerWithItsModuleIsUsedByUrbiSend() throws Exception {
    copy("machine");
    try (JavaProcess urbi =
            launch("-s", "machine", "-H", "127.0.0.1", "-P", "0", "-w", "port", "-d", "LOG");
        ServerProcess server = new ServerProcess(urbi)) {
      assertEquals(server.port() + "\n", Files.readString(folder.resolve("port")));
      program().talkByUrbiSend("--port-file=port");
      assertEquals(0, server.shutDown(), server::text);
    }
  }

  @Test
  void aRunningServerIsGivenModules() throws Exception {
    copy("machine");
    try (ServerProcess server = ServerProcess.in(built)) {
      String port = "--port=" + server.port();
      assertEquals("", program().output("--plugin", port, "machine"));
      assertEquals("", program().output("-p", port, modules.jar("adder").toString()));
      program().talkByUrbiSend(port);
      failsToLaunch(
          "urbi-launch-java: loadModule: file not found: nowhere", "--plugin", port, "nowhere");
      assertEquals(0, server.shutDown(), server::text);
    }
  }

  @Test
  void anotherProgramMayBeTheServer() throws Exception {
    copy("machine");
    Path program = folder.resolve("server");
    Files.writeString(program, "#!/bin/sh\necho \"$@\"\nexit 7\n");
    assertTrue(program.toFile().setExecutable(true));
    try (JavaProcess launch =
        launch("--start", "--customize", program.toString(), "-P", "0", "machine", "--", "-q")) {
      assertEquals(7, launch.awaitEnd(), launch::text);
      assertEquals(
          "--port 0 --module " + folder.toRealPath().resolve("machine.jar") + " -q",
          launch.text().replace(folder.toString(), folder.toRealPath().toString()));
    }
  }

  // ------------------------------------------------------------------ remote

  @Test
  void aModuleRunsInAProcessOfItsOwn() throws Exception {
    here = here.with("URBI_UOBJECT_PATH", "nowhere:" + built);
    modules.jar("machine");
    try (ServerProcess server = ServerProcess.in(folder, "--port-file", "port");
        JavaProcess machine = launch("--port-file", "port", "machine.jar")) {
      machine.awaitText("running on 127.0.0.1:" + server.port());
      program().talkByUrbiSend("--port-file=port");
      assertEquals(0, server.shutDown(), server::text);
      machine.awaitEnd();
    }
  }

  @Test
  void theServerMayComeLater() throws Exception {
    Files.writeString(folder.resolve("port"), FreePorts.next() + "\n");
    copy("machine");
    try (JavaProcess machine = launch("--wait=10min", "--port-file", "port", "machine.jar");
        ServerProcess server = ServerProcess.in(folder, "--port-file", "port")) {
      machine.awaitText("running on 127.0.0.1:" + server.port());
      assertEquals(0, server.shutDown(), server::text);
      machine.awaitEnd();
    }
  }

  @Test
  void modulesMadeByHandRunWithoutTheTools() throws Exception {
    Path api = Path.of(UObject.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    javac(api, folder, MACHINE.resolve("Machine.java"), MACHINE.resolve("UMachine.java"));
    String classes = folder.toString();
    tool(
        "jar",
        List.of(
            "-cf",
            folder.resolve("machine.jar").toString(),
            "-C",
            classes,
            "UMachine.class",
            "-C",
            classes,
            "Machine.class"));
    Files.delete(folder.resolve("Machine.class"));
    try (ServerProcess server = ServerProcess.in(folder);
        JavaProcess machine =
            JavaProcess.start(
                here.withClassPath(api.toString()),
                "urbi.UMain",
                List.of("./machine.jar", "-P", String.valueOf(server.port())))) {
      machine.awaitText("running on 127.0.0.1:" + server.port());
      program().talkByUrbiSend("--port=" + server.port());
      assertEquals(0, server.shutDown(), server::text);
      machine.awaitEnd();
    }
  }

  @Test
  void aProgramMayLoadTheLibraryThatItOnceNeeded() throws Exception {
    Path api = Path.of(UObject.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    Path source = Files.writeString(folder.resolve("Main.java"), CLASSIC_MAIN);
    javac(
        Path.of(api + ":" + built),
        folder,
        source,
        MACHINE.resolve("Machine.java"),
        MACHINE.resolve("UMachine.java"));
    Path script = Path.of("..", "scripts", "java-library.sh").toAbsolutePath();
    Process make = new ProcessBuilder(script.toString(), folder.toString()).inheritIO().start();
    assumeTrue(make.waitFor() == 0, "there is a C compiler");
    here = here.with("LD_LIBRARY_PATH", folder.toString());
    try (ServerProcess server = ServerProcess.in(folder);
        JavaProcess program =
            JavaProcess.start(
                here.withClassPath(api + ":" + folder),
                "Main",
                List.of("-P", String.valueOf(server.port())))) {
      program.awaitText("running on 127.0.0.1:" + server.port());
      program().talkByUrbiSend("--port=" + server.port());
      assertEquals(0, server.shutDown(), server::text);
      program.awaitEnd();
    }
  }

  @Test
  void debugLevelControlsTheLog() throws Exception {
    copy("machine");
    try (ServerProcess server = ServerProcess.in(folder);
        JavaProcess machine = launch("-P" + server.port(), "-d", "TRACE", "machine")) {
      machine.awaitText("running on 127.0.0.1:" + server.port());
      program().talkByUrbiSend("--port=" + server.port());
      machine.awaitText("UMachine.assemble[[12, 34]]");
      failsToLaunch("no level of messages: LOUD", "-P" + server.port(), "-d", "LOUD", "machine");
      assertEquals(0, server.shutDown(), server::text);
      machine.awaitEnd();
    }
  }

  private static void javac(Path classPath, Path output, Path... sources) {
    List<String> words =
        new ArrayList<>(
            List.of("-proc:none", "-cp", classPath.toString(), "-d", output.toString()));
    for (Path source : sources) {
      words.add(source.toString());
    }
    tool("javac", words);
  }

  private static void tool(String name, List<String> words) {
    int status =
        ToolProvider.findFirst(name)
            .orElseThrow()
            .run(System.out, System.err, words.toArray(String[]::new));
    assertEquals(0, status, name);
  }

  @Test
  void classesMayBeSharedByModules() throws Exception {
    Path api = Path.of(UObject.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    Path library = Files.createDirectory(folder.resolve("library"));
    Path module = Files.createDirectory(folder.resolve("module"));
    javac(api, library, MACHINE.resolve("Machine.java"));
    javac(Path.of(api + ":" + library), module, MACHINE.resolve("UMachine.java"));
    try (ServerProcess server = ServerProcess.in(folder);
        JavaProcess machine = launch("-P" + server.port(), "-c", library.toString(), "module")) {
      machine.awaitText("running on 127.0.0.1:" + server.port());
      program().talkByUrbiSend("--port=" + server.port());
      assertEquals(0, server.shutDown(), server::text);
      machine.awaitEnd();
    }
  }

  // ------------------------------------------------------------------ what goes wrong

  @Test
  void missingModuleIsReported() throws Exception {
    failsToLaunch("urbi-launch-java: no module nowhere in .", "nowhere");
    failsToLaunch("urbi-launch-java: no such module: /no/such.jar", "--start", "/no/such.jar");
  }

  @Test
  void missingServerIsReported() throws Exception {
    copy("machine");
    int port = FreePorts.next();
    failsToLaunch("cannot connect to 127.0.0.1:" + port, "-P" + port, "machine");
    failsToLaunch("? urbi --port " + port + " starts one", "-P" + port, "machine");
    failsToLaunch("cannot connect to 127.0.0.1:" + port, "-P" + port, "--plugin", "machine");
    failsToLaunch("is the server running?", "--port-file", "no-port", "machine");
  }

  @Test
  void moduleThatCannotBeRunIsReported() throws Exception {
    Files.writeString(folder.resolve("text.jar"), "no jar", StandardCharsets.UTF_8);
    Path library = Files.createDirectory(folder.resolve("library"));
    Path api = Path.of(UObject.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    javac(api, library, MACHINE.resolve("Machine.java"));
    String where = library.toString();
    String jar = folder.resolve("empty.jar").toString();
    tool("jar", List.of("-cf", jar, "-C", where, "Machine.class"));
    Path part = Files.createDirectory(folder.resolve("part"));
    javac(Path.of(api + ":" + library), part, MACHINE.resolve("UMachine.java"));
    Path source = folder.resolve("Thrower.java");
    Files.writeString(source, THROWER);
    javac(api, Files.createDirectory(folder.resolve("thrower")), source);
    try (ServerProcess server = ServerProcess.in(folder)) {
      String port = "-P" + server.port();
      failsToLaunch("not a jar file", port, "text");
      failsToLaunch("no UObject in", port, "empty");
      failsToLaunch("constructing the UObjects of part: missing class Machine", port, "part");
      failsToLaunch("constructing the UObjects of thrower: no device", port, "thrower");
      assertEquals(0, server.shutDown(), server::text);
    }
  }

  @Test
  void requestedInformationIsPrinted() throws Exception {
    assertEquals(folder.toString(), program().output("--print-root"));
    assertEquals("", program().output("--check"));
    assertTrue(program().output("--version").startsWith("urbi-launch-java version "));
    assertTrue(program().output("--help").contains("--port-file"));
  }
}
