package org.urbi.server.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.server.cli.UrbiProcess.Result;

/** The command line as a user sees it: what is printed, and how it ends. */
class UrbiCommandTest {
  @TempDir Path folder;

  private Result urbi(String... args) throws Exception {
    return UrbiProcess.run(folder, args);
  }

  private String file(String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text).toString();
  }

  @Test
  void aClassicalProgram() throws Exception {
    assertEquals(
        new Result(0, "[] *** Hello, World!", ""),
        urbi("-q", "-e", "echo(\"Hello, World!\");", "-e", "shutdown;"));
  }

  @Test
  void inputsAccumulateInOneLobby() throws Exception {
    String two = file("two.u", "var two = 2;");
    try (UrbiProcess urbi =
        new UrbiProcess(folder, Map.of(), "-q", "-e", "var one = 1;", "-f", two, "-i")) {
      urbi.send("one + two;\n");
      assertEquals(new Result(0, "[] 1\n[] 2\n[] 3", ""), urbi.result());
    }
  }

  @Test
  void theBannerComesFirstUnlessQuiet() throws Exception {
    String out = urbi("-e", "echo(1);").out();
    assertTrue(out.startsWith("[] *** ****"), out);
    assertTrue(out.contains("Urbi version"), out);
    assertTrue(out.endsWith("[] *** 1"), out);
  }

  @Test
  void aScriptHasItsArgumentsAndItsErrorsTheirPlace() throws Exception {
    String script = file("echo.u", "#! /usr/bin/env urbi\nSystem.arguments;\nnowhere;\n");
    Result run = urbi("-q", script, "1", "-x", "--help");
    assertEquals(1, run.status());
    assertEquals(
        "[] [\"1\", \"-x\", \"--help\"]\n[:error] !!! " + script + ":3.1-7: lookup failed: nowhere",
        run.out());
  }

  @Test
  void errorsAreExplainedToWhoAsksForIt() throws Exception {
    String script = file("open.u", "function f(x)\n{\n  echo(x;\n};\n");
    String place = "[:error] !!! " + script + ":3.9: syntax error: unexpected ;";
    assertEquals(
        place
            + """

              3 |   echo(x;
                |       - opened here
                |         ^
                hint: `)' is missing before `;', or `,' was meant, as between elements and arguments\
            """,
        urbi("-q", "--errors", "explained", script).out());
    assertEquals(place, urbi("-q", "--errors", "plain", script).out());
    assertEquals(place, urbi("-q", script).out());
    String coloured = urbi("-q", "--errors", "coloured", script).out();
    assertTrue(coloured.contains("\u001B[1;31m^\u001B[0m"), coloured);
    assertEquals(2, urbi("-q", "--errors", "loud", script).status());
  }

  @Test
  void afterAScriptComesTheStandardInput() throws Exception {
    String script = file("one.u", "var one = 1;");
    try (UrbiProcess urbi = new UrbiProcess(folder, Map.of(), "-q", script)) {
      urbi.send("one + 1;");
      assertEquals(new Result(0, "[] 1\n[] 2", ""), urbi.result());
    }
  }

  @Test
  void theExitStatusIsThatOfShutdown() throws Exception {
    assertEquals(42, urbi("-q", "-e", "shutdown(42);").status());
  }

  @Test
  void aRunEndsAfterItsLastJob() throws Exception {
    assertEquals(
        new Result(0, "[] *** first\n[] *** last", ""),
        urbi("-qF", "-e", "{ sleep(2h); echo(\"last\") }, { sleep(1h); echo(\"first\") },"));
  }

  @Test
  void aRecordedRunIsReplayedWithoutItsFiles() throws Exception {
    Path script = folder.resolve("script.u");
    Files.writeString(
        script, "echo(System.arguments); sleep(10ms); echo(1000.random); shutdown(7);");
    Result run = urbi("-q", "--record", "run", script.toString(), "word");
    assertEquals(7, run.status());
    Files.delete(script);
    assertEquals(run, urbi("--replay", "run"));
    assertEquals(2, urbi("--replay", "run", "-e", "1;").status());
    assertEquals(
        new Result(1, "", "urbi: cannot read the recording no: no"), urbi("--replay", "no"));
    Files.writeString(folder.resolve("text"), "echo(1);");
    assertEquals(new Result(1, "", "urbi: text is no recording of urbi"), urbi("--replay", "text"));
    assertEquals(1, urbi("--record", "no/such/run", "-e", "1;").status());
  }

  @Test
  void aRecordedRunThatEndsByItselfIsReplayedWithItsStatus() throws Exception {
    Result run = urbi("-qF", "--record", "run", "-e", "echo(1); { sleep(1h); 1 / 0 },");
    assertEquals(1, run.status());
    assertEquals(run, urbi("--replay", "run"));
  }

  @Test
  void theExitStatusTellsOfErrorsThatNobodyHandled() throws Exception {
    assertEquals(1, urbi("-q", "-e", "1 +; echo(2);").status());
    assertEquals(1, urbi("-q", "-e", "{ sleep(10ms); throw 1 },").status());
    assertEquals(1, urbi("-q", "-m", "no-such-module", "-e", "echo(1);").status());
    assertEquals(1, urbi("-q", "-m", "no-such-module").status());
    assertEquals(0, urbi("-q", "-e", "throw 1; shutdown;").status());
    assertEquals(1, urbi("-q", "--strict", "-e", "throw 1; shutdown;").status());
    assertEquals(5, urbi("-q", "--strict", "-e", "throw 1; shutdown(5);").status());
    assertEquals(0, urbi("-q", "--strict", "-e", "try { throw 1 } catch {}; shutdown;").status());
  }

  @Test
  void filesAreLoadedBesideTheOneThatLoadsThem() throws Exception {
    Files.createDirectories(folder.resolve("away"));
    file("away/first.u", "load(\"second.u\"); requireFile(\"third.u\");");
    file("away/second.u", "requireFile(\"third.u\"); echo(2);");
    file("away/third.u", "echo(3);");
    assertEquals(
        new Result(0, "[] *** 3\n[] *** 2", ""),
        urbi("-q", folder.resolve("away/first.u").toString()));
    assertEquals(new Result(0, "[] *** 3\n[] *** 2", ""), urbi("-q", "away/first.u"));
  }

  @Test
  void startFilesAreFoundInThePath() throws Exception {
    file("global.u", "var Global.everywhere = 1|; echo(\"loading\");");
    file("local.u", "var here = 2|;");
    Map<String, String> path = Map.of("URBI_PATH", folder.toString());
    try (UrbiProcess urbi = new UrbiProcess(folder, path, "-q", "-e", "everywhere; here;")) {
      Result run = urbi.result();
      assertEquals("[] 1\n[] 2", run.out());
      assertTrue(run.err().endsWith("*** loading"), run.err());
    }
  }

  @Test
  void aServerServesUntilItIsInterrupted() throws Exception {
    Path portFile = folder.resolve("port");
    try (UrbiProcess urbi =
        new UrbiProcess(
            folder,
            Map.of(),
            "-q",
            "--port=0",
            "--port-file=" + portFile,
            "-e",
            "echo(System.listenPort);")) {
      String port = urbi.line().replace("[] *** ", "");
      assertTrue(port.matches("\\d+"), port);
      assertEquals(port + "\n", Files.readString(portFile));
      urbi.interrupt();
      assertEquals(new Result(0, "", ""), urbi.result());
      assertFalse(Files.exists(portFile));
    }
  }

  @Test
  void thePortFileOfAServerThatWasKilledGoesBeforeAnybodyBelievesIt() throws Exception {
    String portFile = file("port", "1\n");
    file("global.u", "echo(Path.new(\"port\").exists);");
    Map<String, String> path = Map.of("URBI_PATH", folder.toString());
    try (UrbiProcess urbi =
        new UrbiProcess(
            folder, path, "-q", "--port=0", "--port-file=" + portFile, "-e", "shutdown;")) {
      Result run = urbi.result();
      assertTrue(run.err().contains("*** false"), run.err());
    }
  }

  @Test
  void terminatedServerRemovesItsPortFile() throws Exception {
    Path portFile = folder.resolve("port");
    try (UrbiProcess urbi =
        new UrbiProcess(
            folder, Map.of(), "-q", "--port=0", "--port-file=" + portFile, "-e", "echo(\"up\");")) {
      assertEquals("[] *** up", urbi.line());
      assertTrue(Files.exists(portFile));
      urbi.terminate();
      assertFalse(Files.exists(portFile));
    }
  }

  @Test
  void anInterruptKillsTheForegroundJobOfASession() throws Exception {
    try (UrbiProcess urbi = new UrbiProcess(folder, Map.of(), "-q", "-i")) {
      urbi.send("echo(\"busy\"); sleep(inf);\n");
      assertEquals("[] *** busy", urbi.line());
      urbi.interrupt();
      assertEquals("[:error] !!! received interruption, killing foreground job.", urbi.line());
      urbi.send("echo(\"alive\");\n");
      assertEquals("[] *** alive", urbi.line());
      assertTrue(urbi.isAlive());
      assertEquals(0, urbi.result().status());
    }
  }

  @Test
  void missingInputsAreReported() throws Exception {
    assertEquals(new Result(1, "", "urbi: no such file: no/such.u"), urbi("-f", "no/such.u"));
    Result bad = urbi("--bogus");
    assertEquals(2, bad.status());
    assertTrue(bad.err().contains("--bogus") && bad.err().contains("--help"), bad.err());
    Result level = urbi("-d", "LOUD", "-e", "1;");
    assertEquals(2, level.status());
    assertTrue(level.err().contains("LOUD") && level.err().contains("TRACE"), level.err());
  }

  @Test
  void optionsForFoxgloveThatMakeNoSenseAreRefused() throws Exception {
    Result watch = urbi("--watch", "x", "-e", "1;");
    assertEquals(2, watch.status());
    assertTrue(watch.err().contains("--watch needs --studio or --mcap"), watch.err());
    Result site = urbi("--studio=0", "--studio-origin", "friend.example,", "-e", "1;");
    assertEquals(2, site.status());
    assertTrue(site.err().contains("https://HOST"), site.err());
    Result replay = urbi("--replay", "run", "--mcap", "x.mcap");
    assertEquals(2, replay.status());
    assertTrue(replay.err().contains("nothing else"), replay.err());
  }

  @Test
  void codeOpensTheStudioAndRecordsVariables() throws Exception {
    String program =
        file(
            "program.u",
            """
            function why(f) { try { f() } catch (var e) { e.message } }|;
            var address = System.openStudio(0)|;
            [address == System.studio, address == System.openStudio];
            why(function () { System.openStudio(77777) });
            why(function () { System.stopMcap });
            System.startMcap("values.mcap");
            why(function () { System.startMcap("others.mcap") }).split(" to ")[0];
            System.stopMcap;
            why(function () { System.startMcap("no/such/values.mcap") }).split(": ")[1];
            why(function () { System.startMcap(".") }).split(": ")[1];
            """);
    Result run = urbi("-q", "--record", "run", program);
    assertEquals(
        """
        [] [true, true]
        [] "invalid port: 77777"
        [] "no variables are being recorded"
        [] "variables are being recorded already,"
        [] "no such directory"
        [] "not a regular file"\
        """,
        run.out());
    byte[] file = Files.readAllBytes(folder.resolve("values.mcap"));
    String end = new String(file, file.length - 8, 8, StandardCharsets.ISO_8859_1);
    assertEquals("\u0089MCAP0\r\n", end, "it is complete");
    Files.delete(folder.resolve("values.mcap"));
    assertEquals(run.out(), urbi("--replay", "run").out());
    assertFalse(Files.exists(folder.resolve("values.mcap")), "a replay records nothing");
  }

  @Test
  void portInUseIsReported() throws Exception {
    try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      Result run = urbi("-q", "-P", String.valueOf(taken.getLocalPort()));
      assertEquals(1, run.status());
      assertTrue(run.err().contains("127.0.0.1:" + taken.getLocalPort()), run.err());
    }
  }

  @Test
  void theRootFolderIsTold() throws Exception {
    assertEquals(new Result(0, folder.toString(), ""), urbi("--print-root"));
  }
}
