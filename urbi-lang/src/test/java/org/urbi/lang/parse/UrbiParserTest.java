package org.urbi.lang.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.print.Printer;
import org.urbi.lang.source.Source;

class UrbiParserTest {
  private static UrbiParser.Parsed parse(String text) {
    return UrbiParser.parse(new Source(text, 1, new Source.Line(0, null, 1)));
  }

  private static Ast first(String text) {
    var parsed = parse(text);
    assertEquals("[]", parsed.errors().toString());
    return parsed.program().statements().getFirst();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '@',
      quoteCharacter = '`',
      textBlock =
          """
          -2 ** 2                  @ 2.'**'(2).'-'()
          1 + 2 * 3                @ 1.'+'(2.'*'(3))
          2 ** 3 ** 2              @ 2.'**'(3.'**'(2))
          !a == b                  @ a.'=='(b).'!'()
          a not in b               @ b.hasNot(a)
          new Foo(1)               @ Foo.new(1)
          1h 2min                  @ 3720
          0xFF                     @ 255
          1.foo                    @ 1.foo
          "a\\x41" "\\B(3)(";))"   @ "aA\\";)"
          x = 10 time: 5s sin: 1s  @ x = 10 time: 5 sin: 1
          x = sin: 1s ampli: 2     @ x = sin: 1 ampli: 2
          a.x->p = 3               @ a.x->p = 3
          x'd                      @ x.'\\'d'
          obj.'+'(x)               @ obj.'+'(x)
          e!(1) ~ 2s               @ e!(1) ~ 2
          f(var x = 1, t: {2})     @ f(var x = 1, t: { 2 })
          (1,)                     @ (1,)
          [ => ]                   @ [ => ]
          a | b |                  @ a | b | {}
          function (a, b) {a + b}  @ function (var a, var b) { a.'+'(b) }
          f(1)(2)                  @ f(1)(2)
          """)
  void parses(String text, String printed) {
    assertEquals(printed, Printer.print(first(text)));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '@',
      quoteCharacter = '`',
      textBlock =
          """
          *;                @ 1.1     @ unexpected *
          if (a) b; else c  @ 1.11-14 @ unexpected else
          123foo;           @ 1.1-6   @ invalid token: <123foo'
          bar qux;          @ 1.8     @ unexpected ;
          1 +               @ 1.4     @ unexpected end of command
          1 + var x;        @ 1.5-9   @ declaration not allowed here
          1 in l in m;      @ 1.8-9   @ unexpected in
          for, (2) x;       @ 1.1-4   @ invalid flavor: for,
          function (a[], b) {}; @ 1.10-17 @ argument after list-argument
          try {} catch {} catch {}; @ 1.17-24 @ catch: exception already caught by a previous clause
          """)
  void reports(String text, String location, String message) {
    SyntaxError error = parse(text).errors().getFirst();
    assertEquals("syntax error: " + message, error.message().replace('`', '<'));
    if (!message.endsWith("command")) {
      assertEquals(location, error.span().location().toString());
    }
  }

  @Test
  void reportsCharacters() {
    assertEquals("syntax error: invalid character: `#'", parse("#;").errors().getFirst().message());
    assertEquals(
        "syntax error: invalid character: `\\xc3'", parse("\u00c3;").errors().getFirst().message());
  }

  @ParameterizedTest
  @ValueSource(strings = {"(", "[", "{", "-", "!", "a:", "if (a) ", "f(", "a = ", "1+", "a."})
  void survivesNesting(String piece) {
    assertEquals(1, parse(piece.repeat(100_000) + "a").errors().size());
  }

  @Test
  void nestsAsPeopleDo() {
    String text = "(".repeat(200) + "1" + ")".repeat(200);
    assertEquals(1, assertInstanceOf(Ast.FloatLiteral.class, first(text)).value());
  }

  @Test
  void tagsTheWholeAssignment() {
    var tagged = assertInstanceOf(Ast.Tagged.class, first("res = t: every (1s) x"));
    assertInstanceOf(Ast.Assignment.class, tagged.tag());
    assertTrue(tagged.body() instanceof Ast.Every);
  }
}
