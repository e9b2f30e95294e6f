package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.error.Errors;
import org.urbi.kernel.error.HelpText;
import org.urbi.kernel.error.Hint;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.ProblemKind;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.lobby.Diagnostics;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.remote.RemoteTransport;
import org.urbi.lang.problem.SyntaxHint;
import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.problem.Template;
import org.urbi.server.net.ConsoleServer;

/**
 * All messages of the language are in the catalogues, {@link Problem} and {@link SyntaxProblem},
 * and nowhere else; what {@code help} says and the hints are in catalogues of their own. The test
 * examines the compiled classes.
 */
class CatalogueTest {
  /** A new message as it should not be: {@link MessageUses} must find each. */
  @SuppressWarnings("unused")
  private static final class Violations {
    String sentence() {
      return Problem.UNKNOWN_HOST.text("that is not there");
    }

    String joined(String name) {
      return Problem.UNKNOWN_HOST.text("no host " + name);
    }

    IllegalStateException literal() {
      return new IllegalStateException("broken");
    }

    IllegalStateException put(String name, Exception cause) {
      return new IllegalStateException("broken " + name, cause);
    }

    UrbiException own(UrbiObject value) {
      return new UrbiException(value);
    }

    void filled(Errors errors, String name) {
      errors.of(Problem.VOID).with("message", "no such " + name + " at all");
    }

    void told(Output output) {
      Diagnostics.error(output, "something is wrong");
    }

    String mark(String text) {
      return "!!! " + text;
    }

    String tooMany() {
      return Problem.UNKNOWN_HOST.text("a", "b");
    }

    String tooFew() {
      return SyntaxProblem.INCOMPATIBLE_KEYWORDS.text("a");
    }

    UrbiException thrown(Errors errors) {
      return errors.primitive("f", Problem.BROKEN_PIPE);
    }
  }

  /** What is said to another process: {@link MessageUses} must find each but the last two. */
  @SuppressWarnings("unused")
  private static final class Speaker {
    private String reason = "the process is gone";

    String returned() {
      return "no such thing";
    }

    String joined(String name) {
      return "no such " + name + " here";
    }

    void closes(RemoteTransport way) {
      way.close("it says nothing");
    }

    void logs(Throwable failure) {
      FailureLog.internal("the test of texts", failure);
    }

    String word() {
      return "gone";
    }
  }

  private static final MessageUses USES = new MessageUses();

  @BeforeAll
  static void read() throws IOException {
    USES.readModuleOf(Problem.class);
    USES.readModuleOf(SyntaxProblem.class);
    USES.readAround(ConsoleServer.class);
  }

  private static void assertNone(Stream<String> found) {
    assertEquals("", String.join("\n", found.toList()));
  }

  @Test
  void noTextIsOutsideTheCatalogue() {
    assertNone(USES.literals().stream());
    assertNone(USES.excusedInVain().stream());
  }

  @Test
  void eachMessageIsUsed() {
    Set<Enum<?>> unused = new TreeSet<>((a, b) -> a.name().compareTo(b.name()));
    unused.addAll(EnumSet.allOf(Problem.class));
    unused.addAll(EnumSet.allOf(SyntaxProblem.class));
    unused.addAll(EnumSet.allOf(Hint.class));
    unused.addAll(EnumSet.allOf(HelpText.class));
    unused.addAll(EnumSet.allOf(SyntaxHint.class));
    unused.removeAll(USES.used());
    assertNone(unused.stream().map(Enum::name));
  }

  @Test
  void eachPlaceIsFilled() {
    assertNone(USES.misfilled().stream());
    assertTrue(USES.filled() > 150, "only " + USES.filled() + " calls were looked at");
  }

  @Test
  void onlyExceptionsAreThrown() {
    assertNone(USES.thrownTexts().stream());
  }

  @Test
  void noTextOccursTwice() {
    assertDistinct(
        Stream.of(Problem.values()).map(problem -> problem.kind() + " " + problem.template()));
    assertDistinct(
        Stream.of(SyntaxProblem.values())
            .map(problem -> problem.kind() + " " + problem.template()));
    assertDistinct(Stream.of(Hint.values()).map(hint -> hint.template().text()));
    assertDistinct(Stream.of(SyntaxHint.values()).map(hint -> hint.template().text()));
    assertDistinct(Stream.of(HelpText.values()).map(text -> text.template().text()));
  }

  private static void assertDistinct(Stream<String> texts) {
    Set<String> seen = new HashSet<>();
    assertNone(texts.filter(text -> !seen.add(text)));
  }

  @Test
  void hintsAreShort() {
    Stream.of(
            Stream.of(Problem.values()).flatMap(problem -> problem.hint().stream()),
            Stream.of(SyntaxProblem.values()).flatMap(problem -> problem.hint().stream()),
            Stream.of(Hint.values()).map(hint -> hint.template().text()),
            Stream.of(SyntaxHint.values()).map(hint -> hint.template().text()))
        .flatMap(hints -> hints)
        .forEach(hint -> {
          assertTrue(hint.length() <= 100, hint);
          assertFalse(hint.endsWith("."), hint);
        });
  }

  @Test
  void violationsAreFound() throws IOException {
    MessageUses uses = new MessageUses();
    uses.read(Violations.class);
    assertEquals(8, uses.literals().size(), uses.literals().toString());
    assertEquals(2, uses.misfilled().size(), uses.misfilled().toString());
    assertEquals(1, uses.thrownTexts().size(), uses.thrownTexts().toString());
  }

  @Test
  void whatIsSaidToOthersIsFound() throws IOException {
    MessageUses uses = new MessageUses();
    uses.readSpeaker(Speaker.class);
    assertEquals(4, uses.literals().size(), uses.literals().toString());
  }

  @Test
  void aTemplateIsFilledInItsOrder() {
    Template template = new Template("{a} and {b}, {}");
    assertEquals(List.of("a", "b"), template.places());
    assertEquals("1 and {a}, {}", template.fill(1, "{a}"));
    assertEquals(ProblemKind.PRIMITIVE, Problem.DIVISION_BY_ZERO.kind());
  }
}
