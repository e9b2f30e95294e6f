package org.urbi.lang.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.print.Printer;

class UrbiParserTest {
  private static ParseResult parse(String text) {
    return UrbiParser.parse(text, null);
  }

  private static Ast one(String text) {
    ParseResult parsed = parse(text);
    assertEquals(List.of(), parsed.errors(), text);
    assertEquals(1, parsed.sequence().statements().size(), text);
    return parsed.sequence().statements().get(0);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '#',
      quoteCharacter = '`',
      value = {
        "1 + 2 * 3          # 1.'+'(2.'*'(3))",
        "1 - 2 - 3          # 1.'-'(2).'-'(3)",
        "-2 ** 2            # 2.'**'(2).'-'()",
        "2 ** 3 ** 2        # 2.'**'(3.'**'(2))",
        "2 ** -1 * 3        # 2.'**'(1.'-'()).'*'(3)",
        "- - 1              # 1.'-'().'-'()",
        "+a.b               # a.b.'+'()",
        "!a == b            # a.'=='(b).'!'()",
        "!a in b            # b.has(a.'!'())",
        "1 + !a             # 1.'+'(a.'!'())",
        "a << 1 + 2         # a.'<<'(1.'+'(2))",
        "2 < 6 === true     # 2.'<'(6).'==='(true)",
        "a ^ b == c         # a.'^'(b.'=='(c))",
        "a bitor b in c     # c.has(a.'bitor'(b))",
        "a && b || c && d   # a && b || c && d",
        "a and not b or c   # a && b.'!'() || c",
        "(a || b) && c      # (a || b) && c",
        "x not in l         # l.hasNot(x)",
        "a = b = c          # a = b = c",
        "a + b = c          # a.'+'(b = c)",
        "a[1] = 2           # a[1] = 2",
        "a[1, 2][3]         # a.'[]'(1, 2).'[]'(3)",
        "a[i] += 1          # a[i] += 1",
        "a.b++ + 1          # a.b++.'+'(1)",
        "i++.print()        # i++.print()",
        "!count -= 1        # (count -= 1).'!'()",
        "compl 0            # 0.'compl'()",
        "a xor_eq 2         # a ^= 2",
        "a not_eq b         # a.'!='(b)",
        "f(1)(2)            # f(1).'()'(2)",
        "f(1, 2,)           # f(1, 2)",
        "x.f->p = 1         # x.f->p = 1",
        "&x.y               # &x.y",
        "a.&b               # a.&b",
        "1 . operator +(2)  # 1.'+'(2)",
        "new.new(new)       # new.new(new)",
        "get + set.import   # get.'+'(set.import)",
        "'if'.'1 2'.ok      # 'if'.'1 2'.ok",
        "e!                 # e!",
        "e!(1)              # e!(1)",
        "x'd                # x.'\\'d'",
        "2 + 3min           # 2.'+'(180)",
        "watch(x % 2)       # watch(x.'%'(2))",
        "var this.'[]'      # var this.'[]'",
        "const var x = 1    # const var x = 1",
        "x = 0 sin: 1s ampli: 2    # x = 0 sin: 1 ampli: 2",
        "x = sin: 1s ampli: 2      # x = sin: 1 ampli: 2",
        "var y = 1 + 2 time: 5s    # var y = 1.'+'(2) time: 5",
        "(var a, [var b]) = c      # (var a, [var b]) = c",
        "BIN 3 jpeg;a;b            # Binary.new(\"jpeg\", \"a;b\")",
      })
  void groupsExpressions(String text, String printed) {
    ParseResult parsed = parse(text);
    assertEquals(List.of(), parsed.errors());
    assertEquals(printed, Printer.print(parsed.sequence().statements().get(0)));
  }

  @ParameterizedTest
  @CsvSource({
    "42, 42",
    "1.25, 1.25",
    "1e3, 1000",
    "1E-5, 1e-5",
    "1_000_000, 1000000",
    "0x2a, 42",
    "0XFFFFFFFF, 4294967295",
    "180deg, 3.141592653589793",
    "200grad, 3.141592653589793",
    "2rad, 2",
    "1ms, 0.001",
    "1min, 60",
    "1h 2min 3s, 3723",
    "0.5d, 43200",
    "1s 1ms, 1.001",
  })
  void readsNumbers(String text, double value) {
    var number = assertInstanceOf(Ast.FloatLiteral.class, one(text));
    assertEquals(value, number.value(), 1e-12);
  }

  /** All digits of four million would take minutes, in which nobody could end it. */
  @Test
  void readsHexadecimalNumbersOfManyDigits() {
    assertEquals(42, hexadecimal("0".repeat(2000) + "2a"));
    assertEquals(Math.scalb(1.0, 1023), hexadecimal("7" + "f".repeat(255)));
    assertEquals(Double.POSITIVE_INFINITY, hexadecimal("f".repeat(256)));
    assertEquals(Double.POSITIVE_INFINITY, hexadecimal("f".repeat(4_000_000)));
  }

  private static double hexadecimal(String digits) {
    return assertInstanceOf(Ast.FloatLiteral.class, one("0x" + digits)).value();
  }

  @Test
  void readsStrings() {
    String[][] cases = {
      {"\"\"", ""},
      {"\"a\" \"b\"\n\"c\"", "abc"},
      {"\"\\a\\b\\f\\n\\r\\t\\v\\\\\\\"\"", "\007\b\f\n\r\t\013\\\""},
      {"\"\\0\\00\\0000\\62\\x41\\xfF\"", "\0\0\0" + "02A\u00ff"},
      {"\"\\B(3)(\"\\\")\"", "\"\\\""},
      {"\"\\B(0)()x\"", "x"},
      {"\"a\nb\"", "a\nb"},
    };
    for (String[] one : cases) {
      var string = assertInstanceOf(Ast.StringLiteral.class, one(one[0]), one[0]);
      assertEquals(one[1], string.value(), one[0]);
    }
  }

  @Test
  void composesStatements() {
    var sequence = parse("a; b, c | d & e | f;").sequence();
    assertEquals(
        List.of(Ast.Flavor.SEMICOLON, Ast.Flavor.COMMA, Ast.Flavor.SEMICOLON),
        sequence.separators());
    var pipe = assertInstanceOf(Ast.Sequence.class, sequence.statements().get(2));
    assertEquals(List.of(Ast.Flavor.PIPE, Ast.Flavor.PIPE), pipe.separators());
    var and = assertInstanceOf(Ast.Sequence.class, pipe.statements().get(1));
    assertEquals(List.of(Ast.Flavor.AND), and.separators());
  }

  @Test
  void completesPipes() {
    var pipe = assertInstanceOf(Ast.Sequence.class, one("a |"));
    assertEquals(2, pipe.statements().size());
    assertInstanceOf(Ast.Scope.class, pipe.statements().get(1));
  }

  @Test
  void keepsFormals() {
    var function =
        assertInstanceOf(Ast.Function.class, one("function (a, var b : Float = 1, c[],) {}"));
    assertEquals(3, function.formals().size());
    assertEquals("b", function.formals().get(1).name());
    assertTrue(function.formals().get(2).variadic());
    assertInstanceOf(Ast.Message.class, function.formals().get(1).type());
    assertEquals(null, assertInstanceOf(Ast.Function.class, one("function {}")).formals());
  }

  @Test
  void typesVariables() {
    var declaration = assertInstanceOf(Ast.Declaration.class, one("var x : Float = 3"));
    assertEquals("x", declaration.name());
    assertEquals("Float", ((Ast.Message) declaration.type()).name());
    assertInstanceOf(Ast.FloatLiteral.class, declaration.value());
  }

  @Test
  void knowsEveryLoop() {
    assertEquals(Ast.Flavor.COMMA, assertInstanceOf(Ast.Every.class, one("every (1s) a")).flavor());
    assertEquals(Ast.Flavor.PIPE, assertInstanceOf(Ast.Every.class, one("every| (1) a")).flavor());
    assertEquals(Ast.Flavor.COMMA, assertInstanceOf(Ast.Loop.class, one("loop, a")).flavor());
    assertInstanceOf(Ast.For.class, one("for (var i = 0 | var j = 1; i < 2; i++) a"));
    assertInstanceOf(Ast.For.class, one("for (;;) a"));
    assertEquals("x", assertInstanceOf(Ast.ForEach.class, one("for (var x in l) a")).name());
    assertEquals("x", assertInstanceOf(Ast.ForEach.class, one("for& (var x : l) a")).name());
    assertEquals(null, assertInstanceOf(Ast.ForEach.class, one("for (3) a")).name());
  }

  @Test
  void readsConditions() {
    var at = assertInstanceOf(Ast.At.class, one("at sync (e?(1, var x) if x ~ 1s) a onleave b"));
    var emitted = assertInstanceOf(Ast.WhenEmitted.class, at.condition());
    assertTrue(at.sync());
    assertEquals(2, emitted.patterns().size());
    assertInstanceOf(Ast.Message.class, emitted.guard());
    assertInstanceOf(Ast.FloatLiteral.class, emitted.duration());
    var when = assertInstanceOf(Ast.Whenever.class, one("whenever (x == 2 ~ 2s) a else b"));
    assertInstanceOf(Ast.WhenTrue.class, when.condition());
    var emit = assertInstanceOf(Ast.Emit.class, one("e!(1) ~ 300ms"));
    assertEquals(0.3, ((Ast.FloatLiteral) emit.duration()).value());
  }

  @Test
  void locatesNodes() {
    ParseResult parsed = UrbiParser.parse("1;\n  foo.bar(\n 1);\n//#line 7 \"g.u\"\nx", "f.u");
    var statements = parsed.sequence().statements();
    assertEquals("f.u:1.1", statements.get(0).span().location().toString());
    assertEquals("f.u:2.3-3.3", statements.get(1).span().location().toString());
    assertEquals("f.u:2.7-9", ((Ast.Message) statements.get(1)).nameSpan().location().toString());
    assertEquals("g.u:7.1", statements.get(2).span().location().toString());
  }

  @Test
  void spansParentheses() {
    assertEquals("(a + b).c", one("(a + b).c").span().text());
    assertEquals("(a) + (b)", one("(a) + (b)").span().text());
  }

  @Test
  void refusesDepth() {
    for (String unit :
        List.of(
            "(",
            "[",
            "{",
            "- ",
            "!",
            "f(",
            "a = ",
            "if (1) ",
            "t: ",
            "function () {",
            "a ** ",
            "if (1) {} else ",
            "[1, ",
            "do {",
            "at (e?) ")) {
      ParseResult parsed = parse(unit.repeat(100_000));
      assertEquals(1, parsed.errors().size(), unit);
    }
    for (String chain : List.of("1 + ", "a.", "a && ", "a in ")) {
      ParseResult parsed = parse(chain.repeat(100_000) + "1");
      assertEquals(1, parsed.errors().size(), chain);
    }
    assertEquals(
        "syntax error: nesting too deep",
        parse("(".repeat(100_000) + "1" + ")".repeat(100_000)).errors().get(0).message());
    assertEquals(List.of(), parse("{".repeat(200) + "}".repeat(200)).errors());
    assertEquals(List.of(), parse("(".repeat(400) + "1" + ")".repeat(400)).errors());
    assertEquals(List.of(), parse("1" + " + 1".repeat(1000)).errors());
    assertEquals(List.of(), parse("a;".repeat(10_000)).errors());
  }
}
