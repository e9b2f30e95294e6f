package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.urbi.tests.process.TypedTerminal.END;
import static org.urbi.tests.process.TypedTerminal.ENTER;
import static org.urbi.tests.process.TypedTerminal.INTERRUPT;
import static org.urbi.tests.process.TypedTerminal.SUSPEND;
import static org.urbi.tests.process.TypedTerminal.TAB;
import static org.urbi.tests.process.TypedTerminal.UP;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** People who type at the editor of {@code urbi -i}. One session serves most of the tests. */
class TerminalTest {
  private static final Pattern COLOUR = Pattern.compile("\u001B\\[(\\d+;)*[349]\\d(;\\d+)*m");

  /** What the terminal is told when the editor ends: that pasted text need not be marked. */
  private static final String EDITOR_ENDS = "\u001B[?2004l";

  @TempDir private static Path folder;
  private static TypedTerminal user;

  /** All that is typed here is typed before there is an editor, as people do who know their way. */
  @BeforeAll
  static void typeAhead() throws Exception {
    user = new TypedTerminal(folder, Map.of("NO_COLOR", "1"));
    user.enter("./urbi -i");
    user.enter("var ahead = 40|;");
    user.enter("ahead +");
    user.enter("2;");
    user.await("] 42");
  }

  /** Whoever closes the window ends the session, though a job runs for ever. */
  @AfterAll
  static void hangUp() throws InterruptedException {
    user.enter("loop { sleep(10ms) },");
    user.close();
  }

  private static Path history() {
    return folder.resolve("state/urbi/history");
  }

  private static List<String> remembered(String text) throws IOException {
    return Files.readAllLines(history()).stream().filter(line -> line.contains(text)).toList();
  }

  @Test
  void aStatementOfSeveralLinesIsOneEntryOfTheHistory() throws Exception {
    user.enter("[1,");
    user.await("[> ");
    user.enter("\"a\\\"b;\"];");
    user.await("] [1, \"a\\\"b;\"]");
    user.enter(UP);
    user.await("] [1, \"a\\\"b;\"]");
    assertEquals(1, remembered("b;").size(), () -> "in " + history());
    for (Path own : List.of(history(), history().getParent())) {
      String permissions = PosixFilePermissions.toString(Files.getPosixFilePermissions(own));
      assertEquals("------", permissions.substring(3), own::toString);
    }
  }

  @Test
  void whatIsOpenStandsBeforeTheNextLine() throws Exception {
    user.enter("{ f(");
    user.await("(> ");
    user.enter("\"x");
    user.await("\"> ");
    user.enter("\") /* {");
    user.await("/*> ");
    user.enter("*/ } // (");
    user.await(";> ");
    user.enter("; 20 + 23;");
    user.await("lookup failed: f");
    user.await("] 43");
  }

  /** What is pasted is one text, also by a terminal that does not mark it. */
  @Test
  void whatNoSeparatorWouldMendIsToldAtOnce() throws Exception {
    user.enter("functon f(x) { x }");
    user.await("did you mean `function'?");
    user.enter("20 + 24;");
    user.await("] 44");
    user.enter("functon g(x)" + ENTER + "{ x };" + ENTER + "20 + 25;");
    user.await("did you mean `function'?");
    String then = user.await("] 45");
    assertFalse(then.contains("!!!"), then);
  }

  @Test
  void helpAndListsOfNamesHaveNoColours() throws Exception {
    user.enter("help(\"List.map\");");
    user.await("map");
    user.type("\"\".to" + TAB);
    user.await("Upper");
    user.enter("Upper;");
    user.await("] \"\"");
    user.enter("nobody.knows;");
    user.await("lookup failed: nobody");
    assertFalse(COLOUR.matcher(user.text()).find(), user::text);
  }

  private static String sums(int from) {
    return IntStream.range(0, 200)
        .mapToObj(i -> from + " + " + i + ";")
        .collect(Collectors.joining(ENTER));
  }

  private static void awaitSums(int from) throws InterruptedException {
    for (int i = 0; i < 200; i++) {
      user.await("] " + (from + i));
    }
  }

  @Test
  void nothingOfALongPasteIsLost() throws Exception {
    user.enter(sums(2000));
    awaitSums(2000);
    // As terminals do who tell what is pasted.
    user.enter("\u001B[200~" + sums(3000) + "\u001B[201~");
    awaitSums(3000);
  }

  @Test
  void typingWhileAJobPrintsLosesNothing() throws Exception {
    user.enter("detach({ for (var i : 200) { echo(\"line %s.\" % i); sleep(2ms) } }),;");
    user.await("*** line 3.");
    int began = user.text().length();
    for (char key : ("\"" + "abcdefghij".repeat(5) + "\".size + 600;").toCharArray()) {
      user.type(String.valueOf(key));
    }
    user.enter("");
    user.enter("700;");
    user.await("] 650");
    user.await("] 700");
    for (int i = 4; i < 200; i++) {
      String line = "*** line " + i + ".\r\n";
      if (!user.text().contains(line)) {
        user.await(line);
      }
    }
    assertFalse(user.text().substring(began).contains("syntax error"), user::text);
  }

  /**
   * Types something, and presses Ctrl-C when it is there: keys of the same instant may go with it.
   */
  private static void drop(String text) throws InterruptedException {
    user.type(text);
    user.await(text);
    user.type(INTERRUPT);
  }

  @Test
  void ctrlCDropsWhatWasTypedAndEndsWhatRunsInTheForeground() throws Exception {
    user.enter("var kept = 3|; kept + 800;");
    user.await("] 803");
    user.enter("kept = {");
    user.await("{> ");
    drop("nonsense");
    user.await(EDITOR_ENDS);
    user.enter("kept + 801;");
    user.await("] 804");
    user.enter("echo(\"waiting\") | waituntil(false);");
    user.await("*** waiting");
    user.enter("{");
    user.await("{> ");
    drop("typed ahead");
    user.await("received interruption, killing foreground job.");
    user.enter("805;");
    user.await("] 805");
  }

  /**
   * Whatever comes between two keys: a key that counted twice would end the session with the second
   * statement that is dropped, because a second interrupt does that.
   */
  @Test
  void statementsCanBeDroppedOneAfterTheOther() throws Exception {
    for (int i = 0; i < 10; i++) {
      user.enter("[");
      user.await("[> ");
      drop("dropped " + i);
      user.await(EDITOR_ENDS);
    }
    user.enter("900;");
    user.await("] 900");
  }

  @Test
  void ctrlZGivesTheTerminalToTheShellUntilFg() throws Exception {
    user.enter("[810,");
    // The system drops what is typed ahead of a Ctrl-Z that comes before the editor does.
    user.await("[> ");
    user.type("820" + SUSPEND);
    user.await("Stopped");
    user.enter("stty -a | tr ';' '\\n'; echo in the $((1 + 1))nd shell");
    String settings = user.await("in the 2nd shell");
    assertFalse(settings.contains("-icanon") || settings.contains("-echo "), settings);
    user.enter("fg");
    user.await("820");
    user.enter("];");
    user.await("] [810, 820]");
  }

  @Test
  void ctrlDEndsTheSessionAfterTheStatementThatRuns(@TempDir Path home) throws Exception {
    try (TypedTerminal other = new TypedTerminal(home, Map.of())) {
      other.enter("./urbi -i");
      other.enter("echo(\"begun\"); var n = 0|; while (n < 10000000) n += 1; n + 42;");
      other.await("*** begun");
      other.type(END);
      other.await("] 10000042");
      other.await(TypedTerminal.ENDED);
    }
  }

  /** The system keeps what was typed before there was an editor, and has made something of it. */
  @Test
  void ctrlDThatIsTypedAheadEndsTheSessionAfterItsStatements(@TempDir Path home) throws Exception {
    try (TypedTerminal other = new TypedTerminal(home, Map.of())) {
      other.enter("./urbi -i; stty -a; echo over $((1 + 1))");
      other.type("1 + 41;" + ENTER + END);
      other.await("] 42");
      other.await(TypedTerminal.ENDED);
      String settings = other.await("over 2");
      assertFalse(settings.contains("-icanon") || settings.contains("-echo "), settings);
    }
  }
}
