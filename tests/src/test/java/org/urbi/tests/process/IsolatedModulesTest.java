package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.urbi.kernel.Kernel;
import org.urbi.server.Trace;
import org.urbi.server.isolated.IsolatedProcesses;
import org.urbi.tests.TestTimeout;

/**
 * A module in C++ that does all that a module must not do, in a process of its own: only its
 * objects suffer. One server is enough for all, and one library under several names.
 */
class IsolatedModulesTest {
  private static final String LOAD = "loadModule(\"faulty\", \"isolate\")|;";

  @TempDir static Path folder;
  private static ServerProcess server;
  private ConsoleClient client;

  @BeforeAll
  static void start() throws Exception {
    Path faulty = CxxModules.faulty();
    for (String name : List.of("faulty", "crashes-early", "exits-early", "spins-early")) {
      Files.copy(faulty, folder.resolve(name + ".so"));
    }
    Files.writeString(folder.resolve("noise.so"), "this is no library");
    server = ServerProcess.in(folder, "--max-hold", "3s");
  }

  /** The processes of modules end with the server, however it ends. */
  @AfterAll
  static void end() throws Exception {
    try (ServerProcess ending = server;
        ConsoleClient client = ending.connect()) {
      assertEquals(List.of(), client.answers(LOAD));
      ProcessHandle module = moduleProcess(client);
      ending.close();
      // Not onExit(): its thread is one that all tests of this JVM share, and may block.
      long deadline = System.nanoTime() + TestTimeout.LONG.toNanos();
      while (module.isAlive()) {
        assertTrue(System.nanoTime() < deadline, "the process of the module goes on");
        Thread.sleep(20);
      }
    }
  }

  @BeforeEach
  void connect() throws IOException {
    client = server.connect();
    client.answers("try { unloadModule(\"faulty\") } catch {};");
  }

  @AfterEach
  void disconnect() throws IOException {
    try (ConsoleClient other = server.connect()) {
      assertEquals("[] 3", plain(other.answers("1 + 2;")));
    }
    client.close();
  }

  /** The process itself knows best: what the system tells of others' command lines is cut. */
  private static ProcessHandle moduleProcess(ConsoleClient client) throws IOException {
    String answer = plain(client.answers("Faulty.process;"));
    long number = Long.parseLong(answer.replaceFirst("\\[] \"(\\d+)\"", "$1"));
    return ProcessHandle.of(number).orElseThrow(() -> new AssertionError("no process " + number));
  }

  /** Lines, without time stamps and places. */
  private static String plain(List<String> lines) {
    return String.join("|", lines)
        .replaceAll("\\[\\d+(:error)?\\] ", "[] ")
        .replaceAll("(?<=!!! )\\d+\\.\\d+(-[\\d.]+)?: ", "");
  }

  private String answer(String code) throws IOException {
    return plain(client.answers(code));
  }

  /** Lines that come by themselves, up to the first one with a text. */
  private String awaited(String text) throws IOException {
    String line = client.line();
    while (!line.contains(text)) {
      line = client.line();
    }
    return plain(List.of(line));
  }

  @Test
  void programDoesNotNoticeTheProcess() throws Exception {
    assertEquals("", answer(LOAD));
    assertEquals("[] 5", answer("Faulty.add(2, 3);"));
    // As where it is plugged.
    assertEquals("[] 0", answer("Faulty.hasClient;"));
    assertEquals("[] 7", answer("var f = Faulty.new| f.add(3, 4);"));
    assertEquals("[] true", answer("f.isA(Faulty);"));
    client.send("h: at (f.hit?(var x)) echo(\"hit \" + x);\nf.v = 21|;\n");
    assertEquals("[] *** hit 21", awaited("hit"));
    assertEquals("", answer("waituntil(f.twice == 42)| h.stop;"));
    client.send("at (f.v > 25) echo(\"timer\");\nf.tick(10)|;\n");
    assertEquals("[] *** timer", awaited("timer"));
    assertEquals("[] 1", answer("lobby.budgetUsed(\"processes\");"));
    client.answers("f.chatters(\"a word\"); unloadModule(\"faulty\");");
    server.awaitText("faulty.so: a word");
    assertEquals("[] 0", answer("lobby.budgetUsed(\"processes\");"));
    assertEquals(
        "[] !!! add: x: the module has been unloaded",
        answer("f.add(1, 2);").replaceAll("add: \\w+\\.add", "add: x"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {
        "f.segfault;           | SIGSEGV in            | about to fall",
        "f.aborts;             | SIGABRT               | no way on",
        "f.exits(3);           | exit status 3         |",
        "f.spins;              | Faulty.*spins has not returned for 3 s |",
        "f.doom; Faulty.new;   | SIGSEGV in            |",
      })
  void deathInACallEndsItWithAnError(String code, String how, String words) throws Exception {
    assertEquals("", answer(LOAD + "var f = Faulty.new|;"));
    String died = "the process of faulty.so has ended: " + how;
    String told = answer("try { " + code + " } catch (var e) { echo(e.message) };");
    assertTrue(told.matches(".*" + died + ".*"), told);
    String seen = told.contains("[] !!! ") ? told : told + awaited("has ended: ");
    if (words != null) {
      assertTrue(seen.contains(words) || awaited(words).startsWith("[] !!! "), seen);
      server.awaitText(words);
    }
    assertTrue(seen.matches(".*\\[] !!! " + died + ".*"), seen);
    for (String dead : List.of("f.add(1, 2);", "Faulty.add(1, 2);")) {
      String error = answer(dead);
      assertTrue(error.matches("\\[] !!! add: \\w+.add: " + died + ".*"), error);
    }
    assertEquals("[] 3", answer(LOAD + "Faulty.add(1, 2);"));
  }

  @Test
  void deathByItselfIsTold() throws Exception {
    assertEquals("", answer(LOAD + "var f = Faulty.new| f.crashLater(10);"));
    assertTrue(awaited("has ended").contains("SIGSEGV in"));
    assertEquals("[] 3", answer(LOAD + "Faulty.add(1, 2);"));
  }

  @Test
  void allWhoWaitForADeadProcessAreTold() throws Exception {
    assertEquals("", answer(LOAD));
    ProcessHandle module = moduleProcess(client);
    client.send(
        "var errors = 0|; var begun = 0|;"
            + "for& (1000) { begun++| try { Faulty.rests(1000) } catch (var e) { errors++ } },\n");
    assertEquals("", answer("waituntil(begun == 1000);"));
    module.destroyForcibly();
    assertTrue(awaited("has ended").contains("SIGKILL"));
    assertEquals("[] 1000", answer("waituntil(errors == 1000)| errors;"));
  }

  @Test
  void bytesOnItsStandardOutputHarmNobody() throws Exception {
    assertEquals("", answer(LOAD + "Faulty.writes(512);"));
    assertEquals("[] 3", answer("Faulty.add(1, 2);"));
    assertFalse(server.text().contains("\u001b"), "control characters reach no terminal");
  }

  @ParameterizedTest
  @CsvSource({
    "missing,       file not found",
    "noise,         it is no shared library",
    "crashes-early, has ended: SIGSEGV",
    "exits-early,   has ended: exit status 4",
  })
  void moduleThatCannotBeStartedIsNamed(String name, String why) throws Exception {
    String error = answer("loadModule(\"" + name + "\", \"isolate\");");
    assertTrue(error.startsWith("[] !!! loadModule: "), error);
    assertTrue(error.contains(name) && error.matches(".*(" + why + ").*"), error);
    assertEquals("", answer(until(0)));
  }

  private static String until(int processes) {
    return "while (lobby.budgetUsed(\"processes\") != " + processes + ") sleep(10ms);";
  }

  @Test
  void oneThatIsNotWantedAnyMoreDoesNotStart() throws Exception {
    assertEquals(
        "[] !!! loadModule: no option of modules: isolated (there is: isolate)",
        answer("loadModule(\"faulty\", \"isolated\");"));
    String limited =
        answer("lobby.setBudget(\"processes\", 0)| loadModule(\"exits-early\", \"isolate\");");
    assertTrue(limited.contains("the budget of this lobby is exhausted"), limited);
    assertEquals("", answer("lobby.setBudget(\"processes\", inf)|;"));
    client.send("t: loadModule(\"spins-early\", \"isolate\"),\n");
    assertEquals("", answer(until(1) + "t.stop;" + until(0)));
  }

  @Test
  void oneThatDoesNotStartInTimeIsNamed() throws Exception {
    Consumer<String> nowhere = text -> {};
    try (IsolatedProcesses processes =
            new IsolatedProcesses(
                Duration.ofSeconds(1), Duration.ZERO, new Trace(Trace.Level.NONE, System.err));
        Kernel kernel =
            Kernel.builder()
                .moduleSearchPath(List.of(folder))
                .moduleProcesses(processes)
                .output(nowhere)
                .log(nowhere)
                .start()) {
      Object told =
          kernel.eval(
              "try { loadModule(\"spins-early\", \"isolate\") } catch (var e) { e.message };");
      assertEquals("the process of spins-early.so has ended: not started within 1 s", told);
    }
  }
}
