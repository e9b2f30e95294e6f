package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * SIGTERM ends a server within five seconds, whatever it does (docs/robustness.md). Nothing else
 * would: it may be held for as long as anybody likes, and nobody watches it.
 */
class TerminationTest {
  private static final int TERMINATED = 143;

  private static final long LIMIT_MILLISECONDS = 5000;

  private static final Duration BETWEEN_LOOKS = Duration.ofMillis(50);

  /**
   * The threads that are needed to end: what they could not do on a busy machine does not count.
   */
  private static final String[] NEEDED = {
    "java", "SIGTERM", "urbi-kernel", "urbi-network", "urbi-watchdog", "urbi-memory", "VM Thread"
  };

  @TempDir private Path folder;

  private JavaProcess urbi(JavaProcess.Setting setting, String... options) throws IOException {
    List<String> arguments = new ArrayList<>(List.of("--port", "0"));
    Collections.addAll(arguments, "--max-hold", "0", "--watchdog", "0");
    Collections.addAll(arguments, options);
    return JavaProcess.start(setting, "org.urbi.server.cli.UrbiCommand", arguments);
  }

  private JavaProcess urbi(String... options) throws IOException {
    return urbi(JavaProcess.Setting.in(folder), options);
  }

  private static void endsInTime(JavaProcess process) throws Exception {
    Starvation starvation = Starvation.begin(process.pid(), NEEDED);
    long starved = 0;
    long began = System.nanoTime();
    process.terminate();
    while (!process.endsWithin(BETWEEN_LOOKS)) {
      try {
        starved = Math.max(starved, starvation.milliseconds());
      } catch (IOException e) {
        // It has just ended.
      }
      long wall = TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - began);
      long took = wall - starved;
      assertTrue(
          took <= LIMIT_MILLISECONDS,
          () -> "goes on after " + took + " ms (" + wall + " by the clock): " + process.text());
    }
    assertEquals(TERMINATED, process.awaitEnd(), process.text());
  }

  /** A client does that, and reads nothing any more; then the server is asked to end. */
  private void endsInTimeAfter(JavaProcess process, String program) throws Exception {
    try (ServerProcess server = new ServerProcess(process);
        ConsoleClient client = server.connect()) {
      // What it says before it holds the server would not be heard until it lets others run.
      client.answers("1|;");
      client.send(program + "\n");
      endsInTime(process);
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "while| (true) {};",
        "function z() { try { z } finally { z } }; try { z } finally { loop| {} };",
        "Regexp.new(\"(a*)*b\").match(\"a\" * 40);",
        "System.eval(\"1;\" * 10000000);",
        "loop { echo(\"x\" * 10000) };",
        "var p = Process.new(\"sh\", [\"-c\", \"trap '' TERM; while :; do :; done\"])| p.run| p.join;",
        "at (Lobby.onDisconnect?(var l)) loop| {}; try { sleep(inf) } finally { loop| {} };",
      })
  void whateverAClientDoes(String program) throws Exception {
    endsInTimeAfter(urbi(), program);
  }

  @Test
  void inAFloodOfAClient() throws Exception {
    JavaProcess process = urbi();
    try (ServerProcess server = new ServerProcess(process);
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
      Thread flood =
          Thread.ofPlatform()
              .start(() -> {
                byte[] many = "1;\n".repeat(1 << 12).getBytes();
                try {
                  while (true) {
                    socket.getOutputStream().write(many);
                  }
                } catch (IOException e) {
                  // The server has ended.
                }
              });
      assertTrue(socket.getInputStream().read() >= 0);
      endsInTime(process);
      flood.join();
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "function h() { h() & h() }; h();",
        "loop { var l = []| try { loop| l << \"x\" * 1000 } catch {} };",
      })
  void withLittleMemory(String program) throws Exception {
    endsInTimeAfter(
        urbi(JavaProcess.Setting.in(folder).with("JAVA_TOOL_OPTIONS", "-Xmx64m")), program);
  }

  /** More than a pipe holds. */
  @Test
  void whileItIsRecordedToWhatTakesNothing() throws Exception {
    endsInTimeAfter(
        urbi(JavaProcess.Setting.in(folder).after("mkfifo run && exec 3<>run"), "--record", "run"),
        "\"" + "x".repeat(1 << 20) + "\";");
  }

  @Test
  void whileAComponentInAnotherProcessDoesNotAnswer() throws Exception {
    endsInTimeAfter(
        urbi("--isolate", "--module", StuckModule.in(folder).toString()), "Stuck.park;");
  }

  @Test
  void whileItIsBeingStarted() throws Exception {
    Files.writeString(folder.resolve("global.u"), "cerr << \"begun\"; sleep(1ms); loop| {};\n");
    try (JavaProcess process = urbi()) {
      process.awaitText("begun");
      endsInTime(process);
    }
  }

  @Test
  void whileItsProgramIsAPipeToWhichNobodyWrites() throws Exception {
    Path pipe = folder.resolve("program");
    assertEquals(0, new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor());
    try (JavaProcess process = urbi("-f", "program");
        // Opened when the other end is.
        OutputStream silent = Files.newOutputStream(pipe)) {
      endsInTime(process);
      silent.flush();
    }
  }

  @Test
  void atOnce() throws Exception {
    try (JavaProcess process = urbi()) {
      endsInTime(process);
    }
  }
}
