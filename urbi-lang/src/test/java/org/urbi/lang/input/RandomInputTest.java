package org.urbi.lang.input;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.parse.ParseResult;
import org.urbi.lang.parse.UrbiParser;
import org.urbi.lang.print.Printer;

/** Whatever comes in, a tree or errors come out. */
class RandomInputTest {
  private static final String[] PIECES = {
    "a",
    "b",
    "x1",
    "'q'",
    "1",
    "2.5",
    "3s",
    "0x1f",
    "\"s\"",
    "\"\\n\"",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ";",
    ",",
    "|",
    "&",
    ":",
    "?",
    "~",
    ".",
    ".&",
    "->",
    "=>",
    "=",
    "+=",
    "++",
    "**",
    "*",
    "+",
    "-",
    "<<",
    "==",
    "<",
    "^",
    "!",
    "&&",
    "||",
    "if",
    "else",
    "while",
    "for",
    "loop",
    "every",
    "at",
    "whenever",
    "onleave",
    "waituntil",
    "watch",
    "function",
    "closure",
    "class",
    "enum",
    "do",
    "switch",
    "case",
    "default",
    "try",
    "catch",
    "finally",
    "throw",
    "return",
    "break",
    "var",
    "const",
    "new",
    "this",
    "call",
    "in",
    "not",
    "assert",
    "emit",
    "timeout",
    "stopif",
    "get",
    "set",
    "import",
    "package",
    "sync",
    "time",
    "BIN 2;",
    "//c\n",
    "/*",
    "*/",
    "\n",
    "x'd",
    "self",
    "static",
    "int",
    "#",
    "\\",
    "\"",
    "'",
    "\u00e9",
  };

  private static final String PROGRAM =
      """
      class Foo : Bar, Baz { var x = 1; function init(a, b = 2, c[]) { this.x = a | b++; } }|;
      at sync (e?(var x, [1, var y]) if x < y ~ 2s) { echo("\\B(3)(;;;)") } onleave { t.stop };
      switch (v) { case ("foo", var l) if l.size == 0: 1; default: ["a" => 1, "b" => (2,)] };
      for& (var i : [1, 2]) { every| (1s) if (i in x) break else x = 10 time: 5s };
      try { throw 1 } catch (var e if e.isA(A)) { e } else { 2 } finally { closure () { x } },
      var z = -2 ** 2 + f(1)[2].&g.h->p & Tag.scope: whenever (a.b) { e!(1) ~ 3s } else {};
      """;

  private static void check(String text) {
    ParseResult parsed = UrbiParser.parse(text, null);
    assertEquals(parsed.tree() == null, !parsed.errors().isEmpty());
    if (parsed.valid()) {
      roundTrip(text, parsed.tree());
    }
    parsed.errors().forEach(e -> assertTrue(e.span().location().column() > 0));
    var reader = new StatementReader(null);
    reader.feed(text);
    reader.end();
    for (Item item = reader.next(); item != null; item = reader.next()) {
      if (item instanceof Item.Invalid invalid) {
        assertFalse(invalid.errors().isEmpty());
      }
    }
    reader.unfinished();
  }

  private static void roundTrip(String text, Ast tree) {
    String printed = Printer.print(tree);
    ParseResult again = UrbiParser.parse(printed, null);
    assertEquals(List.of(), again.errors(), () -> text + "\nprinted as\n" + printed);
    assertEquals(printed, Printer.print(again.tree()), () -> text);
  }

  @Test
  void tokenSoup() {
    var random = new Random(42);
    for (int i = 0; i < 6_000; i++) {
      var text = new StringBuilder();
      for (int n = random.nextInt(12); n >= 0; n--) {
        text.append(PIECES[random.nextInt(PIECES.length)]);
        text.append(random.nextInt(4) == 0 ? "" : " ");
      }
      check(text.toString());
    }
  }

  @Test
  void truncations() {
    for (int i = 0; i <= PROGRAM.length(); i++) {
      check(PROGRAM.substring(0, i));
      check(PROGRAM.substring(i));
    }
  }

  @Test
  void mutations() {
    var random = new Random(7);
    List<String> words = new ArrayList<>(List.of(PROGRAM.split("(?<=\\W)|(?=\\W)")));
    for (int i = 0; i < 800; i++) {
      var mutant = new ArrayList<>(words);
      for (int n = random.nextInt(3); n >= 0; n--) {
        int at = random.nextInt(mutant.size());
        switch (random.nextInt(3)) {
          case 0 -> mutant.remove(at);
          case 1 -> mutant.set(at, PIECES[random.nextInt(PIECES.length)]);
          default -> mutant.add(at, mutant.get(random.nextInt(mutant.size())));
        }
      }
      check(String.join("", mutant));
    }
  }
}
