package org.urbi.tests.process;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.tests.TestTimeout;

/** Faults of the machine, and how the server ends (docs/robustness.md). */
class FaultsTest {
  private static final int STUCK = 70;
  private static final int OUTPUT_LOST = 74;
  private static final int MEMORY_EXHAUSTED = 71;
  private static final int TERMINATED = 143;

  /** So often at most a client fills the memory before it is let go. */
  private static final int MOST_FILLS = 10;

  /** Whoever fills the memory is told of little else. */
  private static final int MOST_LINES = 100;

  @TempDir private Path folder;

  private JavaProcess urbi(String shellCommand, String... arguments) throws IOException {
    return JavaProcess.start(
        JavaProcess.Setting.in(folder).after(shellCommand),
        "org.urbi.server.cli.UrbiCommand",
        List.of(arguments));
  }

  @Test
  void fullDiskEndsARunWithAMessage() throws Exception {
    try (JavaProcess urbi = urbi("exec >/dev/full", "-q", "-e", "loop| { echo(1) };")) {
      assertEquals(OUTPUT_LOST, urbi.awaitEnd());
      assertEquals("urbi: cannot write the output: No space left on device", urbi.text());
    }
  }

  @Test
  void failureOfTheLastOutputCounts() throws Exception {
    try (JavaProcess urbi = urbi("exec >/dev/full", "-q", "-e", "echo(1);")) {
      assertEquals(OUTPUT_LOST, urbi.awaitEnd());
    }
  }

  @Test
  void terminationEndsChildProcesses() throws Exception {
    String program =
        "var p = Process.new(\"sh\", [\"-c\", \"echo $$; exec sleep 1000\"])|; p.run;"
            + " echo(\"child \" + p.stdout.getLine); sleep(10ms); loop| {};";
    try (JavaProcess urbi = urbi(":", "-q", "-e", program)) {
      String line = urbi.awaitText("child ");
      long child = Long.parseLong(line.substring(line.indexOf("child ") + 6).strip());
      urbi.terminate();
      assertEquals(TERMINATED, urbi.awaitEnd());
      var process = ProcessHandle.of(child);
      if (process.isPresent()) {
        process.get().onExit().get(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS);
      }
    }
  }

  @Test
  void memoryThatCannotBeFreedEndsTheServer() throws Exception {
    JavaProcess.Setting small =
        JavaProcess.Setting.in(folder).with("JAVA_TOOL_OPTIONS", "-Xmx100m");
    JavaProcess process =
        JavaProcess.start(
            small, "org.urbi.server.cli.UrbiCommand", List.of("-P", "0", "--max-hold", "0"));
    try (ServerProcess server = new ServerProcess(process);
        ConsoleClient client = server.connect()) {
      client.send("var Global.l = []|; loop { l << \"x\" * 1000 };\n");
      assertEquals(MEMORY_EXHAUSTED, process.awaitEnd());
      assertTrue(server.text().contains("urbi: memory "), server.text());
    }
  }

  private ServerProcess small(String... options) throws Exception {
    return ServerProcess.in(
        JavaProcess.Setting.in(folder).with("JAVA_TOOL_OPTIONS", "-Xmx200m"), options);
  }

  private static boolean isOpenAfterFillingMemory(ConsoleClient leak) {
    try {
      fillMemory(leak);
      return true;
    } catch (IOException closed) {
      return false;
    }
  }

  /**
   * Until its jobs are ended for that, or the one that fills it fails by itself. It wants little at
   * a time: whoever wants too much fails although there is room, over and over.
   */
  private static void fillMemory(ConsoleClient leak) throws IOException {
    leak.send("while| (true) l = [\"x\" * 1000, l];\n");
    List<String> heard = new ArrayList<>();
    do {
      assertTrue(heard.size() < MOST_LINES, () -> "memory is not exhausted: " + heard);
      heard.add(leak.line());
    } while (!heard.getLast().contains("!!! memory exhausted"));
  }

  /** What it has made goes with its lobby, though it does not hang up; nothing else has to. */
  @Test
  void lobbyThatHasGrownMostIsEnded() throws Exception {
    try (ServerProcess server = small("--max-hold", "0");
        Judge judge = Judge.of(server);
        ConsoleClient busy = server.connect();
        ConsoleClient leak = server.connect()) {
      busy.send("var turns = 0|; every (10ms) { turns += 1| var s = \"x\" * 100 },\n");
      leak.send("var l = []|\n");
      try {
        fillMemory(leak);
        judge.isAnswered("memory that was exhausted");
        // It holds on to its list: it is let go as well, at once or when it goes on.
        for (int fills = 1; isOpenAfterFillingMemory(leak); fills++) {
          assertTrue(fills < MOST_FILLS, "it still fills the memory");
        }
      } catch (IOException | AssertionError e) {
        throw new AssertionError(server.text(), e);
      }
      server.awaitText("letting Lobby_");
      assertEquals(
          List.of(),
          busy.answers(
              "{ var before = turns| for (100) if (turns == before) sleep(100ms)|"
                  + " if (turns == before) echo(\"the loop has ended\") };"),
          server.text());
      assertEquals(0, server.shutDown());
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "function h(){ h() & h() }; h();",
        "function h(){ h() & h() }; loop { try { h() } catch {} };",
        "for& (3000000) sleep(1000s);",
      })
  void manyJobsDoNotPreventTermination(String program) throws Exception {
    try (ServerProcess server = small();
        ConsoleClient judge = server.connect();
        ConsoleClient bomb = server.connect()) {
      bomb.send(program + "\n");
      for (int i = 0; i < 50; i++) {
        assertEquals(List.of(), judge.answers("sleep(20ms);"));
      }
      server.terminate();
      assertEquals(TERMINATED, server.awaitEnd());
    }
  }

  /** What a program opens, and what it starts, needs descriptors, too; so does the next client. */
  @Test
  void descriptorsThatAProgramTakesAreMissedByItAlone() throws Exception {
    assumeTrue(
        JavaProcess.isDistribution(),
        "without the distribution, each class that is loaded takes a descriptor: see ./check");
    try (ServerProcess server =
            ServerProcess.in(JavaProcess.Setting.in(folder).after("ulimit -n 120"));
        Judge judge = Judge.of(server);
        ConsoleClient greedy = server.connect()) {
      greedy.send(
          "var files = []| try { for (300) files << OutputStream.new(File.new(\"/dev/null\")) }"
              + " catch (var e) { echo(\"files: \" + e.message) };\n");
      judge.isAnswered("files that were opened");
      greedy.send(
          "var sockets = []| try { for (300) { var s = Socket.new| sockets << s|"
              + " s.connect(\"127.0.0.1\", "
              + server.port()
              + ") } } catch (var e) { echo(\"sockets: \" + e.message) };\n");
      for (int i = 0; i < 20; i++) {
        judge.isAnswered("sockets that were opened");
      }
      greedy.send(
          "try { Process.new(\"true\", []).run; } catch (var e) { echo(e.message) };\n"
              + "echo(\"that is all\");\n");
      String line = greedy.line();
      while (!line.endsWith("*** that is all")) {
        line = greedy.line();
      }
      judge.isAnswered("programs that were started");
      assertEquals(List.of(), greedy.answers("for (var s : sockets) s.disconnect;"));
    }
  }

  @Test
  void fullDiskIsAnErrorToWhoWrites() throws Exception {
    try (ServerProcess server = ServerProcess.in(folder, "--record", "/dev/full");
        Judge judge = Judge.of(server);
        ConsoleClient client = server.connect()) {
      client.send(
          "var f = OutputStream.new(File.new(\"/dev/full\"))| try { f << \"x\" * 100000| f.flush }"
              + " catch (var e) { echo(\"caught: \" + e.message) };\n");
      assertTrue(client.line().contains("caught: "), server.text());
      judge.isAnswered("a disk that is full");
      server.awaitText("the run is not recorded any more: ");
      assertEquals(0, server.shutDown());
    }
  }

  /** The component looks at nothing, and neither does anybody whom it keeps waiting. */
  @Test
  void blockedKernelEndsTheProcess() throws Exception {
    Path jar = StuckModule.in(folder);
    String load = "loadModule(\"" + jar + "\");\n";
    try (ServerProcess server = ServerProcess.in(folder, "--watchdog", "2s", "--max-hold", "1s");
        ConsoleClient client = server.connect()) {
      client.send(load + "Stuck.spin;\n");
      assertEquals(STUCK, server.awaitEnd());
      assertTrue(server.text().contains("in Stuck.spin"), server.text());
      assertTrue(server.text().contains("Stuck.spin(Stuck.java:"), server.text());
    }
    try (ServerProcess server = ServerProcess.in(folder, "--watchdog", "16s");
        ConsoleClient client = server.connect()) {
      client.send(load + "Stuck.park;\n");
      server.awaitText("the kernel is held for");
      server.terminate();
      assertEquals(TERMINATED, server.awaitEnd());
    }
  }

  @Test
  void logThatNobodyReadsMakesTheServerNeitherDeafNorImmortal() throws Exception {
    Path port = folder.resolve("port");
    try (JavaProcess urbi =
        urbi("mkfifo log && exec 3<>log 2>log", "-P", "0", "--port-file", port.toString(), "-q")) {
      long end = System.nanoTime() + TestTimeout.LONG.toNanos();
      while (!Files.exists(port)) {
        assertTrue(System.nanoTime() < end, urbi.text());
        Thread.sleep(20);
      }
      int number = Integer.parseInt(Files.readString(port).strip());
      // Each of them is worth a line, and the pipe has room for 64 KiB.
      for (int i = 0; i < 2000; i++) {
        try (Socket refused = new Socket(InetAddress.getLoopbackAddress(), number)) {
          refused.setSoTimeout((int) TestTimeout.LONG.toMillis());
          refused.getOutputStream().write("GET / HTTP/1.1\r\n".getBytes(US_ASCII));
          assertTrue(refused.getInputStream().read() >= 0);
        }
      }
      urbi.terminate();
      assertEquals(TERMINATED, urbi.awaitEnd());
    }
  }

  @Test
  void processesLeaveNoThreads() throws Exception {
    String program =
        "for| (100) { var p = Process.new(\"true\", []) | p.run | p.join };"
            + " echo(Directory.new(\"/proc/self/task\").content.size < 60);";
    try (JavaProcess urbi = urbi(":", "-q", "-e", program)) {
      assertEquals(0, urbi.awaitEnd());
      assertTrue(urbi.text().endsWith("*** true"), urbi.text());
    }
  }

  @Test
  void readingAnEndlessDeviceIsAnError() throws Exception {
    String program =
        "try { File.new(\"/dev/zero\").content } catch (var e) { echo(e.message) }; echo(\"on\");";
    try (JavaProcess urbi = urbi(":", "-q", "-e", program)) {
      assertEquals(0, urbi.awaitEnd());
      assertTrue(urbi.text().contains("/dev/zero"), urbi.text());
      assertTrue(urbi.text().endsWith("*** on"), urbi.text());
    }
  }
}
