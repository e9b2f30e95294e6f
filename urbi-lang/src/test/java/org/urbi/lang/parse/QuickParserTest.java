package org.urbi.lang.parse;

import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.lang.grammar.Checkpoint;
import org.urbi.lang.source.Source;
import org.urbi.lang.text.LineTable;
import org.urbi.lang.text.Sources;
import org.urbi.lang.text.StatementSplitter;

/** What is parsed by hand has the tree that it has by the grammar. */
class QuickParserTest {
  private static final int CHANGES = 6;

  /** How much of the programs of this project is to be parsed by hand. */
  private static final double USUAL = 0.8;

  private int statements;
  private int quick;

  private static Checkpoint never() {
    return new Checkpoint(() -> {});
  }

  /** Whether it is parsed by hand; if so, it must be as by the grammar. */
  private static boolean agrees(String text, boolean single) {
    Source source = Sources.of(text, "file");
    QuickParser.Quick found = QuickParser.parse(source, 0, text.length(), single, never());
    if (found == null) {
      return false;
    }
    ParseResult judge = UrbiParser.byGrammar(source, 0, text.length(), single, never());
    assertEquals(List.of(), judge.errors(), text);
    assertEquals(List.of(), judge.warnings(), text);
    assertEquals(judge.tree(), found.tree(), text);
    assertEquals(judge.separator(), found.separator(), text);
    return true;
  }

  private static List<String> statementsOf(String text) {
    StatementSplitter splitter = new StatementSplitter(new LineTable(null, 1));
    List<String> found = new ArrayList<>();
    int start = 0;
    for (int at = 0; at < text.length(); ) {
      at = splitter.scan(text, at, text.length(), start);
      if (splitter.separator() != null) {
        found.add(text.substring(start, at));
        start = at;
      }
    }
    return found;
  }

  /** The programs and sessions of this project, without the answers. */
  private static List<String> programs() throws IOException {
    List<String> programs = new ArrayList<>();
    for (String folder : new String[] {"tests/src/test/resources", "examples", "share", "bench"}) {
      Path root = Path.of("..", folder);
      try (Stream<Path> files = Files.walk(root)) {
        for (Path file :
            files.filter(f -> f.toString().matches(".*\\.(u|u-session)")).sorted().toList()) {
          String text = Files.readString(file, StandardCharsets.ISO_8859_1);
          programs.add(text.replaceAll("(?m)^(\\[|#).*$", ""));
        }
      }
    }
    return programs;
  }

  @Test
  void programsAreParsedAsByTheGrammar() throws IOException {
    Random random = new Random(1);
    List<String> programs = programs();
    assertTrue(programs.size() > 500, programs.size() + " programs");
    for (String program : programs) {
      agrees(program, false);
      for (String statement : statementsOf(program)) {
        statements++;
        quick += agrees(statement, true) ? 1 : 0;
        agrees(statement.substring(0, statement.length() - 1), false);
        for (int i = 0; i < CHANGES; i++) {
          agrees(changed(statement, random), random.nextBoolean());
        }
      }
    }
    assertTrue(quick > USUAL * statements, quick + " of " + statements + " were usual");
  }

  /** A text that is perhaps no program, or another one. */
  private static String changed(String text, Random random) {
    StringBuilder changed = new StringBuilder(text);
    int at = random.nextInt(text.length());
    int length = random.nextInt(Math.min(8, text.length() - at) + 1);
    String[] pieces = {
      "",
      ";",
      ",",
      "|",
      "&",
      "(",
      ")",
      "{",
      "}",
      "[",
      "]",
      ":",
      "=",
      "!",
      "?",
      "~",
      ".",
      "->",
      "++",
      "var ",
      "x",
      "1",
      "1s",
      "\"s\"",
      "'q'",
      " in ",
      " not ",
      "if ",
      "else ",
      "new ",
      "get ",
      "=>",
      "function ",
      "closure ",
      "call",
      "return ",
      "break",
      "case 1:",
      "default:",
      "at (e?(var x))",
      "loop ",
      "for (var x : l) ",
      "x: ",
      " time: 1s",
      "class C ",
      "try {} ",
      "catch (var e) {} ",
      "this",
      "&x",
      ".&",
      "- ",
      "== ",
      "< ",
      "** ",
      "const ",
      "//",
      "/*",
      "*/",
      "\\",
      "\n",
      "@",
    };
    switch (random.nextInt(3)) {
      case 0 -> changed.delete(at, at + length);
      case 1 -> changed.insert(at, pieces[random.nextInt(pieces.length)]);
      default -> {
        int to = random.nextInt(text.length());
        changed.insert(to, text, at, at + length);
      }
    }
    return changed.toString();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "var x = [1, 2, [\"a\" => 1], (3,), (), [=>],]",
        "function f(var a, b = 1, c[]) { return a + b * -c[0] ** 2 }",
        "class A : B, C { var x; function f() { call.args } }",
        "for (var i = 0; i < 10; i++) { if (i % 2) continue; l << i }",
        "for| (var i in [1, 2]) echo(i) | for& (3) echo(1)",
        "switch (x) { case 1: a; b; case [var y, 2] if y > 3: default: c }",
        "try { throw 1 } catch (var e if e.isA(Float)) { throw } finally { x->p = 2 }",
        "at sync (e?(var x, 1) if x > 2 ~ 1s) { x } onleave y",
        "whenever (x > 2 ~ 100ms) t: loop x++, waituntil (a.b!== 3)",
        "every| (1s) e!(1, 2), timeout (1h 30min) {}, stopif (x) {} & freezeif (e?) {}",
        "a.b.c(1).'d e'[2]++ ; f(&x) ; a.&b ; do (o) { var y = 1 } ; new",
        "a not in b && c in d || e === f ; 0x1F + 1_000.5e-3 + 90deg ; \"a\\n\" \"b\\x41\"",
        "007 + 999999999999999 + 1234567890123456 + 12345678901234567890 + 1.5 + 2e3 + 3s + 4_0",
        "assert (x) ; assert { a == b; c; } ; { ; } | | a & b",
        "while (var x = f()) {} ; if (a; b) c else d ; closure (x) { return x }",
        "set(1, 2) ; get ; set = 3 ; get.x | set[1] = 2 & get!(1) ; set += get() ; set->p",
      })
  void usualTextsAreParsedByHand(String text) {
    assertTrue(agrees(text, false), text);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        ";",
        "a b;",
        "x = 1 time: 1s;",
        "x = sin: 1s;",
        "emit e;",
        "new Object;",
        "self;",
        "BIN 3;abc;",
        "int;",
        "public x;",
        "1m;",
        "1zz;",
        "12\u00e9;",
        "\"\\y\";",
        "\"a;",
        "/* a;",
        "x'd;",
        "return 1;",
        "break;",
        "throw;",
        "call;",
        "{ var x; var x };",
        "if (a);",
        "a < b < c;",
        "var x : T = 1;",
        "a + b: c;",
        "function () {} ~ 1s;",
        "closure {};",
        "a;b;",
        "@;",
        "loop& x;",
        "for, (var x : l) x;",
        "at; (x) y;",
        "f(var x);",
        "1 += 2;",
        "import a.b;",
      })
  void whatIsUnusualIsLeftToTheGrammar(String text) {
    assertNull(QuickParser.parse(Sources.of(text, null), 0, text.length(), true, never()));
  }

  @Test
  void aPartOfATextHasItsPlacesInTheWhole() {
    String text = "xx 1 + 2; yy";
    Source source = Sources.of(text, null);
    QuickParser.Quick found = QuickParser.parse(source, 2, 9, true, never());
    ParseResult judge = UrbiParser.byGrammar(source, 2, 9, true, never());
    assertEquals(judge.tree(), requireNonNull(found).tree());
  }

  @Test
  void deepAndLongTextsAreLeftToTheGrammarOrParsedInLinearTime() {
    for (String text :
        List.of(
            "(".repeat(100_000) + "1" + ")".repeat(100_000) + ";",
            "1" + " + 1".repeat(100_000) + ";",
            "a" + ".a".repeat(100_000) + ";",
            "{".repeat(5_000) + "}".repeat(5_000) + ";",
            "-".repeat(5_000).replace("-", "- ") + "1;",
            "t: ".repeat(5_000) + "1;")) {
      assertNull(QuickParser.parse(Sources.of(text, null), 0, text.length(), true, never()));
    }
    String list = "[" + "1, ".repeat(100_000) + "\"a\\n\"];";
    assertNotNull(QuickParser.parse(Sources.of(list, null), 0, list.length(), true, never()));
  }

  @Test
  void theCheckpointEndsIt() {
    String text = "[" + "1, ".repeat(10_000) + "1];";
    RuntimeException stop = new IllegalStateException("stop");
    Checkpoint checkpoint =
        new Checkpoint(() -> {
          throw stop;
        });
    assertEquals(
        stop,
        assertThrows(
            RuntimeException.class,
            () -> QuickParser.parse(Sources.of(text, null), 0, text.length(), true, checkpoint)));
  }
}
