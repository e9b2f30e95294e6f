package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Hostile, broken and slow clients, one after the other; meanwhile and afterwards another client is
 * answered within a second (see {@link Judge}).
 */
class HostileClientsTest {
  /** What holds the kernel, in few words. */
  private static final List<String> HOLDS =
      List.of(
          "function ff(n){ if (n<2) n else ff(n-1)+ff(n-2) }; ff(60);",
          "while|(true){};",
          "var l=[1]| for|(40) l=[l,l]; l.hash;",
          "var l=[1]| for|(40) l=[l,l]; var m=[1]| for|(40) m=[m,m]; l == m;",
          "var e = Event.new| at (e?) {e!|e!}; e!;",
          "var o = Object.new| for|(20000) o=o.new; o.nowhere;",
          "Regexp.new(\"(a*)*b\").match(\"a\" * 40);",
          "Regexp.new(\"((){1000000}){1000000}\").match(\"a\");",
          "Matrix.new(16777216, 0) * Matrix.new(0, 16777216);",
          "class A { function '<'(o) { loop|{} } }; [A.new, A.new].sort;",
          "class A { function hash() { loop|{} } }; [A.new => 1];",
          "class A { function hash() { 1 } }; var d = [=>]| for| (var i: 100000) d[A.new] = i;",
          "var t = Tag.new| at (t.leave?) { loop|{} }; t: { sleep(1s) }, t.stop;",
          "try { loop|{} } finally { loop|{} };",
          "System.eval(\"1;\" * 1000000);",
          "1" + "&1".repeat(50_000) + ";");

  /** What fills the memory. */
  private static final List<String> CROWDS =
      List.of(
          "function h(){ h() & h() }; h();",
          "for& (300000) sleep(1000s);",
          "var l = []| while|(true) l << \"x\"*1000;",
          "loop { echo(\"x\" * 10000) };");

  /** What reads and writes files without end, or one that has none. */
  private static final List<String> FILES =
      List.of(
          "loop| { try { File.new(\"/dev/zero\").content } catch {} };",
          "loop| { var o = OutputStream.new(File.create(\"one\"))|"
              + " for| (100) o << \"x\" * 10000| o.close };",
          "var o = OutputStream.new(File.create(\"lines\"))| o << \"\\n\" * 1000000| o.close|"
              + " loop| File.new(\"lines\").asList.size;",
          "for| (var i: 1000) File.create(\"file \" + i)| loop| Directory.new(\".\").content;");

  /** What a reader of the log must not be made to believe. */
  private static final String FORGED = "urbi: memory exhausted";

  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  private static final String FLOOD = "loop { echo(\"x\" * 100000) };";

  /** What is no urbiscript, or only the beginning of something. */
  private static final List<String> FRAGMENTS =
      List.of(
          "GET / HT",
          "GET / HTTP/1.1\r\nHost: localhost\r\n",
          "POST / HTTP/1.1\r\n\r\nSystem.shutdown;",
          "\u0016\u0003\u0001\u0002",
          "\u00ff\u00fa\u0018",
          "\"half of a string",
          "/* half of a comment",
          "{ echo(1); ");

  @TempDir private Path folder;

  private final List<Socket> open = new ArrayList<>();

  private Socket send(ServerProcess server, String text) throws IOException {
    Socket socket = new Socket(LOOPBACK, server.port());
    open.add(socket);
    socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
    return socket;
  }

  private static void reset(Socket socket) throws IOException {
    socket.setSoLinger(true, 0);
    socket.close();
  }

  private void closeAll() throws IOException {
    for (Socket socket : open) {
      socket.close();
    }
    open.clear();
  }

  @Test
  void clientThatHoldsTheKernelDelaysNobody() throws Exception {
    anotherClientIsAnsweredWhileAndAfter(HOLDS, "-Xmx2g");
  }

  @Test
  void clientThatFillsTheMemoryDelaysNobody() throws Exception {
    anotherClientIsAnsweredWhileAndAfter(CROWDS, "-Xmx300m");
  }

  @Test
  void clientThatIsBusyWithFilesDelaysNobody() throws Exception {
    anotherClientIsAnsweredWhileAndAfter(FILES, "-Xmx1g");
  }

  /**
   * Sends a command of telnet again and again, and reads no answer, until so many bytes are sent or
   * the server lets it go.
   */
  private static Thread flood(ServerProcess server, String command, int most) {
    byte[] many = command.repeat(1 << 12).getBytes(StandardCharsets.ISO_8859_1);
    return Thread.ofPlatform()
        .start(() -> {
          try (Socket socket = new Socket(LOOPBACK, server.port())) {
            for (int sent = 0; sent < most; sent += many.length) {
              socket.getOutputStream().write(many);
            }
          } catch (IOException e) {
            // It has been let go.
          }
        });
  }

  /** The kernel is held as often as may be, so that it can take no message. */
  @Test
  void floodOfInterruptionsDelaysNobody() throws Exception {
    try (ServerProcess server =
            ServerProcess.in(
                JavaProcess.Setting.in(folder).with("JAVA_TOOL_OPTIONS", "-Xmx200m"),
                "--budget",
                "hold=100");
        Judge judge = Judge.of(server)) {
      send(server, "while|(true){};\n".repeat(20));
      Thread flood = flood(server, "\u00ff\u00f4", 1 << 21);
      do {
        judge.isAnswered("interruptions without end");
      } while (flood.isAlive());
      closeAll();
      judge.isAnswered("interruptions without end, which have ended");
      assertFalse(server.text().contains("memory"), server.text());
      assertEquals(0, server.shutDown());
    } finally {
      closeAll();
    }
  }

  /** Each question is shorter than its answer, which nobody reads. */
  @Test
  void floodOfTelnetQuestionsDelaysNobodyAndIsLetGo() throws Exception {
    try (ServerProcess server =
            ServerProcess.in(
                JavaProcess.Setting.in(folder).with("JAVA_TOOL_OPTIONS", "-Xmx200m"),
                "--max-output",
                "1");
        Judge judge = Judge.of(server)) {
      for (String question :
          List.of("\u00ff\u00f6", "\u00ff\u00fd\u0001", "\u00ff\u00faUinterrupt\u00ff\u00f0")) {
        Thread flood = flood(server, question, Integer.MAX_VALUE / 2);
        do {
          judge.isAnswered("questions of telnet");
        } while (flood.isAlive());
        judge.isAnswered("questions of telnet, which have ended");
      }
      assertEquals(0, server.shutDown());
      assertEquals(3, server.text().split("does not read what it is sent", -1).length - 1);
      assertFalse(server.text().contains("memory"), server.text());
    }
  }

  @Test
  void clientsThatFloodTheLogHideAndForgeNothing() throws Exception {
    try (ServerProcess server = ServerProcess.in(folder, "--budget", "hold=100");
        Judge judge = Judge.of(server)) {
      for (int i = 0; i < 5; i++) {
        send(server, "loop Logger.log(\"x\\n" + FORGED + "\" + \"\\x1b[2J\" * 1000);\n");
        send(server, "loop| Logger.log(\"x\", \"\\n" + FORGED + "\");\n");
        judge.isAnswered("much for the log");
      }
      closeAll();
      judge.isAnswered("much for the log");
      assertEquals(0, server.shutDown());
      List<String> lines = server.text().lines().toList();
      assertTrue(lines.stream().noneMatch(line -> line.startsWith(FORGED)), server.text());
      assertTrue(lines.stream().anyMatch(line -> line.contains("logs too much")), server.text());
      // Of each that has held the kernel the log tells: nothing of the server's own is lost.
      assertFalse(server.text().contains("messages are lost here"), server.text());
      assertFalse(server.text().contains("\u001b"), server.text());
    } finally {
      closeAll();
    }
  }

  /**
   * Ending a recursion of 200,000 calls, each with a handler, takes some tenths of a second on a
   * machine with nothing else to do: the others are answered, but perhaps not within one.
   */
  @Test
  void deepRecursionDelaysOthersButIsEnded() throws Exception {
    try (ServerProcess server =
            ServerProcess.in(
                JavaProcess.Setting.in(folder).with("JAVA_TOOL_OPTIONS", "-Xmx2g"),
                "--budget",
                "hold=200");
        ConsoleClient judge = server.connect()) {
      send(server, "function z(){ try{z()} catch{z()} }; z();\n");
      assertEquals(List.of(), judge.answers("1|;"));
      closeAll();
      assertEquals(List.of(), judge.answers("1|;"));
      assertEquals(0, server.shutDown());
    } finally {
      closeAll();
    }
  }

  /** The virtual machine cannot put such a stack away. */
  @Test
  void deepStackThatCannotLetOthersRunGoesOn() throws Exception {
    try (ServerProcess server = ServerProcess.in(folder);
        ConsoleClient busy = server.connect();
        ConsoleClient deep = server.connect()) {
      busy.send("every (1ms) {},\n");
      String calls = "function f(n) { if (n == 0) 0 else { var rest = f(n - 1); rest + 1 } }|;";
      assertEquals(List.of(), deep.answers(calls));
      assertTrue(deep.answers("f(30000);").getFirst().endsWith("] 30000"));
      assertEquals(0, server.shutDown());
    }
  }

  private static final String TOO_MUCH =
      "the budget of this lobby is exhausted:"
          + " 1048576 bytes allocated without letting others run";

  private static List<String> shown(List<String> lines) {
    return lines.stream().map(line -> line.substring(line.indexOf(']') + 2)).toList();
  }

  /** The server's own program has no budget. Each of them is told by its own exception. */
  @Test
  void clientThatAllocatesTooMuchAtOneGoIsToldAndEnded() throws Exception {
    try (ServerProcess server =
            ServerProcess.in(
                JavaProcess.Setting.in(folder).with("JAVA_TOOL_OPTIONS", "-Xmx300m"),
                "--budget",
                "memory=1M");
        ConsoleClient client = server.connect()) {
      for (String program :
          List.of(
              "var l = []| while|(true) l << \"x\" * 1000;",
              "var s = \"x\"| loop| s = s + s;",
              "var t = \"x\"| loop| { try { loop| t = t + t } catch { } };")) {
        assertEquals(
            "!!! " + TOO_MUCH, client.answers(program).getFirst().replaceFirst(".*(?=!!!)", ""));
      }
      assertEquals(List.of("2"), shown(client.answers("1 + 1;")));
      assertEquals(
          List.of('"' + TOO_MUCH + '"'),
          shown(client.answers("try { \"x\" * 100000000 } catch (var e) { e.message };")));
      assertEquals(0, server.shutDown());
    }
  }

  private void anotherClientIsAnsweredWhileAndAfter(List<String> programs, String memory)
      throws Exception {
    try (ServerProcess server =
            ServerProcess.in(
                JavaProcess.Setting.in(folder).with("JAVA_TOOL_OPTIONS", memory),
                "--budget",
                "hold=100");
        Judge judge = Judge.of(server)) {
      for (String program : programs) {
        // Nobody reads what it answers; the second one vanishes without a word.
        send(server, program + "\n");
        Socket vanishing = send(server, program + "\n");
        for (int i = 0; i < 5; i++) {
          judge.isAnswered(program);
        }
        reset(vanishing);
        judge.isAnswered(program);
        closeAll();
        judge.isAnswered(program);
      }
      assertEquals(0, server.shutDown());
    } finally {
      closeAll();
    }
  }

  /** What they add to a variable is executed by whoever writes or reads it. */
  @Test
  void hooksOfAnotherClientEndNobodyButWhoMeetsThem() throws Exception {
    try (ServerProcess server = ServerProcess.in(folder, "--budget", "hold=100");
        Judge judge = Judge.of(server);
        ConsoleClient hostile = server.connect();
        ConsoleClient writer = server.connect()) {
      hostile.answers(
          "class Global.Hooked { var endless = 0; var slow = 0; var failing = 0;"
              + " for (var name : [\"endless\", \"slow\", \"failing\"]) UVar.new(this, name) }|;"
              + "Hooked.&endless.notifyChange(closure () { loop|{} })|;"
              + "Hooked.&slow.notifyAccess(closure () { loop|{} })|;"
              + "Hooked.&failing.notifyChange(closure () { throw Exception.new(\"of a hook\") })|;"
              + "Hooked.&failing.notifyChange(closure () { Hooked.failing += 1 })|;"
              + "Hooked.&failing.notifyChange(function () { echo(\"the third\") })|;"
              + "at (Hooked.slow > 10) {};");
      for (String meets : List.of("Hooked.endless = 1|;", "Hooked.slow|;")) {
        String told = String.join("\n", writer.answers(meets));
        assertTrue(told.contains("has held the kernel for too long"), told);
        judge.isAnswered(meets);
      }
      assertEquals(List.of("1"), shown(writer.answers("Hooked.endless;")));
      assertEquals(
          List.of(
              "!!! Exception caught while processing notify on Hooked.failing:",
              "!!! of a hook",
              "*** the third"),
          shown(writer.answers("Hooked.failing = 1|;")).stream()
              .filter(line -> !line.contains("called from"))
              .map(line -> line.replaceFirst("!!! [0-9.-]+: ", "!!! "))
              .toList());
      assertEquals(List.of("2"), shown(writer.answers("Hooked.failing;")));
      judge.isAnswered("a hook that fails");
      assertEquals(0, server.shutDown());
    }
  }

  @Test
  void incompleteRequestsAndFloodsDisturbNobody() throws Exception {
    try (ServerProcess server = ServerProcess.in(folder);
        Judge judge = Judge.of(server)) {
      for (String fragment : FRAGMENTS) {
        // One stays, one ends its stream, one is reset.
        send(server, fragment);
        send(server, fragment).shutdownOutput();
        reset(send(server, fragment));
        judge.isAnswered(fragment);
      }
      for (int i = 0; i < 200; i++) {
        reset(send(server, i % 2 == 0 ? "" : "sleep(1000s);\n"));
      }
      judge.isAnswered("a storm");
      closeAll();
      judge.isAnswered("a storm");
      assertEquals(0, server.shutDown());
    } finally {
      closeAll();
    }
  }

  /** Others come and are reset, in great number, while somebody is answered. */
  @Test
  void stormOfResetsDelaysNobody() throws Exception {
    try (ServerProcess server = ServerProcess.in(folder);
        Judge judge = Judge.of(server)) {
      var storm = new AtomicBoolean(true);
      Thread thread =
          Thread.ofPlatform()
              .start(() -> {
                for (int i = 0; storm.get(); i++) {
                  try (Socket socket = new Socket(LOOPBACK, server.port())) {
                    socket.getOutputStream().write(FRAGMENTS.get(i % FRAGMENTS.size()).getBytes());
                    reset(socket);
                  } catch (IOException e) {
                    // The server may be faster than we are.
                  }
                }
              });
      for (int i = 0; i < 100; i++) {
        judge.isAnswered("a storm of resets");
      }
      storm.set(false);
      thread.join();
      judge.isAnswered("a storm of resets, which is over");
      assertEquals(0, server.shutDown());
    }
  }

  /** They want much, and take little of it, or nothing; some end their own half first. */
  @Test
  void slowReadersAndHalfOpenSocketsDelayNobody() throws Exception {
    try (ServerProcess server = ServerProcess.in(folder);
        Judge judge = Judge.of(server)) {
      for (int i = 0; i < 30; i++) {
        Socket socket = send(server, "for (100) echo(\"x\" * 100000);\nloop { echo(1) };\n");
        if (i % 3 == 0) {
          socket.shutdownOutput();
        }
      }
      for (int i = 0; i < 50; i++) {
        for (Socket socket : open) {
          InputStream in = socket.getInputStream();
          if (i % 5 == 0 && in.available() > 0) {
            in.read();
          }
        }
        judge.isAnswered("clients that read slowly");
      }
      for (Socket socket : open) {
        reset(socket);
      }
      judge.isAnswered("slow clients that vanish");
      assertEquals(0, server.shutDown());
    } finally {
      closeAll();
    }
  }

  /** Each leaves behind as many jobs as it may, which go on for ever. */
  @Test
  void whatClientsLeaveBehindDelaysNobody() throws Exception {
    try (ServerProcess server =
            ServerProcess.in(
                JavaProcess.Setting.in(folder).with("JAVA_TOOL_OPTIONS", "-Xmx200m"),
                "--budget",
                "hold=100,jobs=500");
        Judge judge = Judge.of(server)) {
      for (int i = 0; i < 40; i++) {
        send(
            server,
            "function f(){ spawn(closure(){f()}, true); spawn(closure(){f()}, true) }; f();\n");
        judge.isAnswered("jobs that do not belong to the connection");
        closeAll();
        judge.isAnswered("jobs that were left behind");
      }
      assertTrue(server.text().contains("clients that have left may have 500 jobs together"));
      assertEquals(0, server.shutDown());
    } finally {
      closeAll();
    }
  }

  /** Nobody reads what the program of the server itself prints. */
  @Test
  void blockedStandardOutputDelaysNobody() throws Exception {
    JavaProcess.Setting blocked =
        JavaProcess.Setting.in(folder).after("mkfifo pipe; exec <>pipe >pipe");
    try (ServerProcess server = ServerProcess.in(blocked, "-e", FLOOD);
        Judge judge = Judge.of(server)) {
      for (int i = 0; i < 30; i++) {
        judge.isAnswered("output that nobody reads");
      }
      server.terminate();
      assertEquals(143, server.awaitEnd());
    }
  }

  /**
   * Where each doubling of a string collects all garbage twice, the others are answered, but
   * perhaps not within a second.
   */
  @Test
  void littleMemoryIsEnough() throws Exception {
    try (ServerProcess server =
            ServerProcess.in(JavaProcess.Setting.in(folder).with("JAVA_TOOL_OPTIONS", "-Xmx64m"));
        ConsoleClient judge = server.connect()) {
      for (String program :
          List.of(
              "function h(){ h() & h() }; h();",
              "for& (3000000) sleep(1000s);",
              "var s = \"x\"| loop| s = s + s;")) {
        send(server, program + "\n");
        for (int i = 0; i < 10; i++) {
          assertEquals(List.of(), judge.answers("1|;"));
        }
        closeAll();
        assertEquals(List.of(), judge.answers("1|;"));
      }
      assertEquals(0, server.shutDown());
    } finally {
      closeAll();
    }
  }

  @Test
  void runEndsWhenItsReaderHasGone() throws Exception {
    JavaProcess.Setting piped =
        JavaProcess.Setting.in(folder).after("mkfifo pipe; head -n 1 pipe >/dev/null & exec >pipe");
    try (JavaProcess urbi =
        JavaProcess.start(
            piped, "org.urbi.server.cli.UrbiCommand", List.of("-q", "-e", "loop { echo(1) };"))) {
      assertEquals(74, urbi.awaitEnd());
      assertEquals("urbi: cannot write the output: Broken pipe", urbi.text());
    }
  }
}
