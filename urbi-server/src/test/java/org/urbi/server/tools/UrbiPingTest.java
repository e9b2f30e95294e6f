package org.urbi.server.tools;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;

class UrbiPingTest {
  /** What a server answers to {@code lobby.send("N", "ping");}, after a banner. */
  private static final UnaryOperator<String> PONG =
      line -> "[00000001] *** noise\n[00000001:ping] " + line.split("\"")[1] + "\n";

  private static ToolResult ping(String... args) {
    return ToolResult.of(UrbiPing::run, args);
  }

  @Test
  void everyPingIsReportedAndSummedUp() throws Exception {
    try (ScriptedServer server = new ScriptedServer(PONG)) {
      ToolResult run = ping("-P" + server.port(), "--count=3", "--interval=1");
      assertEquals(0, run.status());
      assertTrue(
          run.out()
              .matches(
                  "Pinging 127.0.0.1:"
                      + server.port()
                      + "\\R1: .* ms\\R2: .* ms\\R3: .* ms\\R"
                      + "3 sent, 3 received, min .* ms, mean .* ms, max .* ms\\R"),
          run.out());
    }
  }

  @Test
  void argumentsMayDoWithoutOptionNames() throws Exception {
    try (ScriptedServer server = new ScriptedServer(PONG)) {
      ToolResult run = ping("-P" + server.port(), "localhost", "0", "2");
      assertTrue(run.out().startsWith("Pinging localhost:"), run.out());
      assertEquals(2, run.out().lines().count(), run.out());
      assertTrue(run.out().contains("2 sent, 2 received"), run.out());
    }
  }

  @Test
  void serverThatClosesTheConnectionIsReported() throws Exception {
    try (ScriptedServer server = new ScriptedServer(line -> null)) {
      ToolResult run = ping("-P" + server.port(), "-c1");
      assertEquals(1, run.status());
      assertTrue(run.out().contains("1 sent, 0 received"), run.out());
      assertTrue(run.err().contains("the server hung up"), run.err());
    }
  }

  @Test
  void tooManyArgumentsAreRefused() {
    assertEquals(2, ping("localhost", "1", "2", "3").status());
  }
}
