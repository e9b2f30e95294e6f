package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.tests.process.JavaProcess.Setting;

/** The program {@code urbi-launch} with a library, as the manual's chapter 3 uses it. */
class UrbiLaunchTest {
  private static final String LAUNCH = "org.urbi.server.launch.UrbiLaunch";
  private static Path machine;

  @TempDir Path folder;
  private Launch program;

  @BeforeAll
  static void makeModule() {
    machine = new CxxModules().library("machine");
  }

  @BeforeEach
  void set() throws IOException {
    Files.copy(machine, folder.resolve("machine.so"));
    program = new Launch(Setting.in(folder), LAUNCH);
  }

  @Test
  void aServerIsStartedWithItsModuleAndASession() throws Exception {
    try (JavaProcess urbi = program.start("--start", "machine", "--", "--interactive")) {
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
    try (JavaProcess urbi =
            program.start(
                "-s", "machine.so", "-H", "127.0.0.1", "-P", "0", "-w", "port", "-d", "LOG");
        ServerProcess server = new ServerProcess(urbi)) {
      assertEquals(server.port() + "\n", Files.readString(folder.resolve("port")));
      program.talkByUrbiSend("--port-file=port");
      assertEquals(0, server.shutDown(), server::text);
    }
  }

  @Test
  void aModuleRunsInAProcessOfItsOwn() throws Exception {
    Path elsewhere = Files.createDirectory(folder.resolve("elsewhere"));
    Launch other =
        new Launch(Setting.in(elsewhere).with("URBI_UOBJECT_PATH", "nowhere:" + folder), LAUNCH);
    try (ServerProcess server = ServerProcess.in(folder, "--port-file", "port");
        JavaProcess first =
            other.start(
                "-r", "-H", "127.0.0.1", "-w", folder.resolve("port").toString(), "machine")) {
      first.awaitText("running on 127.0.0.1:" + server.port());
      program.talkByUrbiSend("--port-file=port");
      assertEquals(0, server.shutDown(), server::text);
      first.awaitEnd();
    }
  }

  @Test
  void aRunningServerIsGivenModules() throws Exception {
    try (ServerProcess server = ServerProcess.in(folder)) {
      String port = "--port=" + server.port();
      assertEquals("", program.output("--plugin", port, "machine"));
      program.talkByUrbiSend(port);
      program.fails(1, "urbi-launch: loadModule: file not found: nowhere", "-p", port, "nowhere");
      assertEquals(0, server.shutDown(), server::text);
    }
  }

  @Test
  void anotherProgramMayBeTheServer() throws Exception {
    Path server = folder.resolve("server");
    Files.writeString(server, "#!/bin/sh\necho \"$@\"\nexit 7\n");
    assertTrue(server.toFile().setExecutable(true));
    try (JavaProcess launch =
        program.start("-s", "-c", server.toString(), "-P", "0", "machine", "--", "-q")) {
      assertEquals(7, launch.awaitEnd(), launch::text);
      String real = folder.toRealPath().toString();
      assertEquals(
          "--port 0 --module " + real + "/machine.so -q",
          launch.text().replace(folder.toString(), real));
    }
    program.fails(2, "--customize needs --start", "-c", server.toString(), "machine");
  }

  @Test
  void classesOfAModuleAreListed() throws Exception {
    String described = program.output("--describe", "machine");
    assertTrue(described.endsWith("machine.so\n  class UMachine"), described);
    Files.copy(new CxxModules().library("servohub"), folder.resolve("servohub.so"));
    described = program.output("--describe", "servohub.so");
    assertTrue(described.endsWith("servohub.so\n  hub servohub\n  class servo"), described);
  }

  @Test
  void errorsAreReported() throws Exception {
    program.fails(2, "urbi-launch: no MODULE: which UObjects are to be run?");
    program.fails(2, "choose one of --plugin, --remote", "-p", "-r", "machine");
    program.fails(1, "urbi-launch: no module nowhere in .", "nowhere");
    program.fails(1, "no such module: /no/such.so", "--start", "/no/such.so");
    program.fails(1, "is the server running?", "--port-file", "no-port", "machine");
    Files.writeString(folder.resolve("text.so"), "Once upon a time in a far land");
    program.fails(1, "text.so: it is no shared library", "--describe", "text");
    try (ServerProcess server = ServerProcess.in(folder)) {
      program.fails(1, "text.so: it is no shared library", "-P" + server.port(), "text");
      program.fails(1, "text.so: it is no shared library", "-P" + server.port(), "-p", "text");
      assertEquals(0, server.shutDown(), server::text);
    }
  }

  @Test
  void requestedInformationIsPrinted() throws Exception {
    assertEquals(folder.toString(), program.output("--print-root"));
    assertTrue(program.output("--version").startsWith("urbi-launch version "));
    assertTrue(program.output("-h").contains("--describe"));
  }
}
