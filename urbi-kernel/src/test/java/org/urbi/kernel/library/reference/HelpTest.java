package org.urbi.kernel.library.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Kernel;
import org.urbi.lang.grammar.Keywords;

/** What {@code help} says; the examples of the reference have more. */
class HelpTest {
  private static final BlockingQueue<String> OUTPUT = new LinkedBlockingQueue<>();
  private static Kernel kernel;

  @BeforeAll
  static void start() {
    kernel =
        Kernel.builder()
            .virtualTime(true)
            .output(OUTPUT::add)
            .topics(() -> Map.of("--port", "-P, --port PORT\nListens there, for »robots«."))
            .start();
  }

  @AfterAll
  static void stop() {
    kernel.close();
  }

  /** What a program shows, without the marks before its lines. */
  private static String shown(String code) {
    OUTPUT.clear();
    kernel.eval(code + "; echo(\"the end\"); 0");
    StringBuilder shown = new StringBuilder();
    while (shown.indexOf("*** the end") < 0) {
      shown.append(take());
    }
    return shown
        .toString()
        .lines()
        .filter(line -> !line.endsWith("*** the end"))
        .map(line -> line.replaceFirst("^\\[\\d+] \\*\\*\\* ?", ""))
        .collect(Collectors.joining("\n"));
  }

  private static String take() {
    try {
      return OUTPUT.take();
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void aTypeIsShownWithItsSlots() {
    String list = shown("List.help");
    assertTrue(list.startsWith("List\n\nAny number of values in an order"), list);
    assertTrue(list.contains(", front, head, back, tail,"), list);
    assertEquals(list, shown("help(List)"));
    assertEquals(list, shown("help(\"List\")"));
    assertEquals(list, shown("[1, 2].help"));
  }

  @Test
  void proseFitsATerminalAndLosesNothing() {
    String list = shown("List.help");
    assertTrue(list.contains("Members may be of different\ntypes; indexes count"), list);
    assertTrue(list.contains("negative ones from the end.\n\n"), list);
    for (String topic : HelpTexts.types()) {
      shown("help(\"" + topic + "\")")
          .lines()
          .filter(line -> !line.startsWith("    "))
          .forEach(line -> assertTrue(line.length() <= 102, line));
    }
  }

  @Test
  void aSlotIsFoundInTheTypeThatHasIt() {
    String map = shown("help(\"List.map\")");
    assertTrue(map.startsWith("List.map\n\nmap(fun) -> List: "), map);
    assertEquals(map, shown("[1].help(\"map\")"));
    assertEquals(map, shown("help(List.&map)"));
    assertTrue(shown("help(\"List.each\")").startsWith("List.each\n"));
    assertTrue(shown("help(\"List.clone\")").startsWith("Object.clone\n"));
    assertTrue(shown("help(\"+\")").startsWith("Several types have `+'; ask for one of them:\n"));
    assertTrue(shown("help(\"Float.+\")").startsWith("Float.+\n"));
    assertTrue(shown("help(\"criticalSection\")").startsWith("Semaphore.criticalSection\n"));
  }

  @Test
  void eachKeywordIsShown() {
    for (String word : Keywords.all()) {
      assertTrue(shown("help(\"" + word + "\")").length() > 100, word);
    }
  }

  @Test
  void whatTheProgramKnowsIsShown() {
    assertEquals("-P, --port PORT\nListens there, for »robots«.", shown("help(\"--port\")"));
  }

  @Test
  void whatMayHaveBeenMeantIsProposed() {
    String unknown = "nothing is known of `%s'; ";
    assertEquals(unknown.formatted("--prot") + "did you mean --port?", shown("help(\"--prot\")"));
    assertTrue(shown("help(\"evrey\")").contains("did you mean every"));
    assertTrue(shown("help(\"Lits\")").contains("did you mean List"));
    String none = "help without an argument says what there is";
    assertEquals(unknown.formatted("@") + none, shown("help(\"@\")"));
    assertEquals(unknown.formatted("") + none, shown("help(\"\")"));
    assertEquals(unknown.formatted("..") + none, shown("help(\"..\")"));
    assertTrue(shown("help(\"x\" * 100000)").endsWith(none));
  }

  @Test
  void nothingOfTheUserIsCalled() {
    String user =
        """
        class Trap
        {
          get gate() { throw "called" };
          function asString() { throw "called" };
          function asPrintable() { throw "called" };
          /* Falls,
           * and stays there. */
          function fall(far, fast = 1, how[]) { throw "called" };
          function plain { throw "called" }
        }|;
        var Global.trap = Trap.new|;
        """;
    assertEquals(
        "trap.fall(far, fast = …, how[])\nFalls,\nand stays there.",
        shown(user + "help(\"trap.fall\")"));
    assertEquals("plain", shown("trap.help(\"plain\")"));
    assertTrue(
        shown("help(trap)").startsWith("Trap, made from Object, with these slots:\n  gate,"));
    assertTrue(shown("help(\"trap.gate.x\")").startsWith("nothing is known of"));
    assertEquals("function(x)", shown("help(function (x) { x })"));
  }

  @Test
  void withoutAnArgumentItSaysWhatThereIs() {
    String overview = shown("help");
    assertTrue(overview.startsWith("help(\"List\") tells of a type"), overview);
    assertTrue(overview.contains("Semaphore"), overview);
  }
}
