package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Code in so many nested calls that the virtual machine refuses to put its stack away, on a server:
 * it waits and lets others run as code elsewhere does, and is reached by them.
 */
class DeepStacksTest {
  private static final String DEEP =
      "function deep(n, code) { if (n == 0) code() else { var rest = deep(n - 1, code)| rest } }|;";

  /** Waits until the deep code is at its bottom. */
  private static final String WHEN_THERE = "waituntil (Global.there)| Global.there = false|;";

  /** So many jobs with such stacks can wait at a time. */
  private static final int KEPT = 4;

  @TempDir private Path folder;
  private ServerProcess server;
  private ConsoleClient other;

  @BeforeEach
  void start() throws Exception {
    server = ServerProcess.in(folder);
    other = server.connect();
    other.answers("var Global.t = Tag.new|; var Global.there = false|;");
  }

  @AfterEach
  void end() throws Exception {
    other.close();
    assertEquals(0, server.shutDown());
    server.close();
  }

  /** A client whose code is deep down by now. */
  private ConsoleClient deep(String code) throws Exception {
    return deep(50_000, code);
  }

  private ConsoleClient deep(int calls, String code) throws Exception {
    ConsoleClient client = server.connect();
    assertEquals(List.of(), client.answers(DEEP));
    client.send("t: deep(" + calls + ", closure() { Global.there = true| " + code + " });\n");
    assertEquals(List.of(), other.answers(WHEN_THERE));
    return client;
  }

  private static List<String> shown(List<String> lines) {
    return lines.stream().map(line -> line.substring(line.indexOf(']') + 2)).toList();
  }

  /** Nobody has to be ended for holding the kernel. */
  private void isStoppedByAnother(String code) throws Exception {
    try (ConsoleClient client = deep(code)) {
      assertEquals(List.of(), other.answers("t.stop;"));
      assertEquals(List.of("0"), shown(client.answers("0;")));
    }
  }

  @Test
  void codeThatLetsOthersRunIsStopped() throws Exception {
    isStoppedByAnother("loop {}");
    isStoppedByAnother("while (true) { 1; 2 }");
  }

  @Test
  void codeThatWaitsIsStopped() throws Exception {
    isStoppedByAnother("sleep(1000s)");
    isStoppedByAnother("waituntil (false)");
    isStoppedByAnother("{ sleep(1000s) & sleep(1000s) }");
  }

  @Test
  void codeIsFrozenAndGoesOn() throws Exception {
    try (ConsoleClient client = deep("while (!Global.there) {}| 7")) {
      assertEquals(List.of(), other.answers("t.freeze; sleep(1ms)| Global.there = true|;"));
      assertEquals(List.of("1"), shown(other.answers("1;")));
      assertEquals(List.of(), other.answers("t.unfreeze;"));
      assertEquals(List.of("7"), shown(client.answers("")));
    }
  }

  @Test
  void codeOfWhoLeavesEnds() throws Exception {
    for (String code : List.of("loop {}", "sleep(1000s)")) {
      other.answers("var Global.left = false|;");
      deep("try { " + code + " } finally { Global.left = true }").close();
      assertEquals(List.of(), other.answers("waituntil (Global.left);"));
    }
  }

  /** Each has a thread of its own then, and the loop one more. */
  @Test
  void severalWaitAtATime() throws Exception {
    List<ConsoleClient> clients = new ArrayList<>();
    for (int i = 0; i < KEPT; i++) {
      clients.add(deep("{ for (3) sleep(1ms)| waituntil (Global.there)| " + i + " }"));
    }
    other.answers("Global.there = true|;");
    for (int i = 0; i < KEPT; i++) {
      assertEquals(List.of(String.valueOf(i)), shown(clients.get(i).answers("")));
      clients.get(i).close();
    }
  }

  @Test
  void ofVeryManyTheLastAreToldThatTheyCannotWait() throws Exception {
    List<ConsoleClient> clients = new ArrayList<>();
    for (int i = 0; i < KEPT; i++) {
      clients.add(deep("sleep(1000s)"));
    }
    try (ConsoleClient client = deep("sleep(1000s)")) {
      assertTrue(client.answers("").getFirst().endsWith("!!! stack space exhausted"));
    }
    assertEquals(List.of(), other.answers("t.stop;"));
    for (ConsoleClient client : clients) {
      assertEquals(List.of(), client.answers(""));
      client.close();
    }
    isStoppedByAnother("sleep(1000s)");
  }

  /** A lobby has half of the threads that others leave to it. */
  @Test
  void oneClientDoesNotTakeAllThreads() throws Exception {
    try (ConsoleClient greedy = server.connect()) {
      assertEquals(List.of(), greedy.answers(DEEP));
      for (int i = 0; i < KEPT / 2; i++) {
        greedy.send("t: deep(50000, closure() { Global.there = true| sleep(1000s) }),\n");
        assertEquals(List.of(), other.answers(WHEN_THERE));
      }
      List<String> third = greedy.answers("deep(50000, closure() { sleep(1000s) });");
      assertTrue(third.getFirst().endsWith("!!! stack space exhausted"), third::toString);
      isStoppedByAnother("sleep(1000s)");
    }
  }

  /**
   * A thread that waits with that many calls would make each collection of garbage long for all.
   */
  @Test
  void evenDeeperCodeIsToldThatItCannotWait() throws Exception {
    isRefused(100_000, "sleep(1000s)");
    isRefused(100_000, "Semaphore.new(0).acquire");
    // This wait does not tell in how many calls it is.
    isRefused(100_000, "{ var x = 0| x = 1 time:1000s }");
    // What has waited in fewer has a thread already.
    isRefused(50_000, "sleep(1ms)| deep(50000, closure() { sleep(1000s) })");
    isRefused(50_000, "sleep(1ms)| deep(50000, closure() { var x = 0| x = 1 time:1000s })");
    isStoppedByAnother("deep(50000, closure() { 1 })| sleep(1000s)");
  }

  /** When others ran depended on how long the machine took to refuse; the replay has no clock. */
  @Test
  void recordedRunIsReplayed() throws Exception {
    try (ServerProcess recorded = ServerProcess.in(folder, "--record=run");
        ConsoleClient client = recorded.connect();
        ConsoleClient beside = recorded.connect()) {
      assertEquals(List.of(), client.answers(DEEP + "var Global.n = 0|;"));
      beside.send("every (1ms) Global.n++,\n");
      for (String code :
          List.of(
              "deep(100000, closure() { for (20000) { 1; 2 }| n })",
              "deep(50000, closure() { for (20) { 1; sleep(1ms) }| n })")) {
        assertEquals(1, client.answers(code + ";").size(), code);
      }
      assertTrue(
          client
              .answers("deep(100000, closure() { sleep(1s) });")
              .getFirst()
              .endsWith("!!! stack space exhausted"));
      assertEquals(0, recorded.shutDown());
    }
    try (JavaProcess replay =
        JavaProcess.start(
            JavaProcess.Setting.in(folder),
            "org.urbi.server.cli.UrbiCommand",
            List.of("--replay=run"))) {
      assertEquals(0, replay.awaitEnd(), replay::text);
    }
  }

  private void isRefused(int calls, String code) throws Exception {
    try (ConsoleClient client = deep(calls, code)) {
      assertTrue(client.answers("").getFirst().endsWith("!!! stack space exhausted"), code);
    }
  }
}
