package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Hostile, broken and slow clients, one after the other; meanwhile and afterwards another client is
 * answered.
 */
class HostileClientsTest {
  /** What holds the kernel, in few words. */
  private static final List<String> HOLDS =
      List.of(
          "function ff(n){ if (n<2) n else ff(n-1)+ff(n-2) }; ff(60);",
          "while|(true){};",
          "var l=[1]| for|(40) l=[l,l]; l.hash;",
          "var l=[1]| for|(40) l=[l,l]; var m=[1]| for|(40) m=[m,m]; l == m;",
          "function z(){ try{z()} catch{z()} }; z();",
          "var e = Event.new| at (e?) {e!|e!}; e!;",
          "var o = Object.new| for|(20000) o=o.new; o.nowhere;",
          "Regexp.new(\"(a*)*b\").match(\"a\" * 40);",
          "1" + "&1".repeat(50_000) + ";");

  /** What fills the memory. */
  private static final List<String> CROWDS =
      List.of(
          "function h(){ h() & h() }; h();",
          "for& (300000) sleep(1000s);",
          "var l = []| while|(true) l << \"x\"*1000;",
          "loop { echo(\"x\" * 10000) };");

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
    Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port());
    open.add(socket);
    socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
    return socket;
  }

  private static void reset(Socket socket) throws IOException {
    socket.setSoLinger(true, 0);
    socket.close();
  }

  private static void answers(ServerProcess server, ConsoleClient judge, String after)
      throws IOException {
    try {
      assertEquals(List.of(), judge.answers("1|;"));
    } catch (IOException | AssertionError e) {
      throw new AssertionError("after " + after + ": " + server.text(), e);
    }
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

  private void anotherClientIsAnsweredWhileAndAfter(List<String> programs, String memory)
      throws Exception {
    try (ServerProcess server =
            ServerProcess.in(
                JavaProcess.Setting.in(folder).with("JAVA_TOOL_OPTIONS", memory),
                "--max-hold",
                "500ms");
        ConsoleClient judge = server.connect()) {
      for (String program : programs) {
        // Nobody reads what it answers; the second one vanishes without a word.
        send(server, program + "\n");
        Socket vanishing = send(server, program + "\n");
        for (int i = 0; i < 5; i++) {
          answers(server, judge, program);
        }
        reset(vanishing);
        answers(server, judge, program);
        closeAll();
        answers(server, judge, program);
      }
      assertEquals(0, server.shutDown());
    } finally {
      closeAll();
    }
  }

  @Test
  void incompleteRequestsAndFloodsDisturbNobody() throws Exception {
    try (ServerProcess server = ServerProcess.in(folder);
        ConsoleClient judge = server.connect()) {
      for (String fragment : FRAGMENTS) {
        // One stays, one ends its stream, one is reset.
        send(server, fragment);
        send(server, fragment).shutdownOutput();
        reset(send(server, fragment));
        answers(server, judge, fragment);
      }
      for (int i = 0; i < 200; i++) {
        reset(send(server, i % 2 == 0 ? "" : "sleep(1000s);\n"));
      }
      answers(server, judge, "a storm");
      closeAll();
      answers(server, judge, "a storm");
      assertEquals(0, server.shutDown());
    } finally {
      closeAll();
    }
  }

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
          answers(server, judge, program);
        }
        closeAll();
        answers(server, judge, program);
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
