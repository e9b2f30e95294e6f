package org.urbi.lang.print;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.parse.ParseResult;
import org.urbi.lang.parse.UrbiParser;

class PrinterTest {
  private static Ast one(String text) {
    ParseResult parsed = UrbiParser.parse(text, null);
    assertEquals(List.of(), parsed.errors(), text);
    assertEquals(1, parsed.sequence().statements().size(), text);
    return parsed.sequence().statements().get(0);
  }

  private static void prints(String text, String printed) {
    assertEquals(printed, Printer.print(one(text)));
    assertEquals(printed, Printer.print(one(printed)));
  }

  @Test
  void functionsOfOneStatement() {
    prints("function(){}", "function () {}");
    prints("function () { x; }", "function () { x }");
    prints("closure(a,b){a+b}", "closure (var a, var b) { a.'+'(b) }");
    prints("function { call.args }", "function { call.args }");
    prints(
        "function f(a, b = 1, c[]) { return a * b; }",
        "function f(var a, var b = 1, var c[]) { return a.'*'(b) }");
    prints("function () { a | b & c }", "function () { a | b & c }");
    prints("function () { a, }", "function () { a, }");
  }

  @Test
  void functionsOfSeveralStatements() {
    prints(
        "function(){ foo(1); return 2; }",
        """
        function () {
          foo(1);
          return 2;
        }\
        """);
    prints(
        "function () { var a.b = 0; class C : D { x }; e! ~ 2s; [\"k\"=>1]; for(var i : 3) {}; z }",
        """
        function () {
          var a.b = 0;
          class C: D
          {
            x
          };
          e! ~ 2;
          [
            "k" => 1,
          ];
          for (var i : 3)
          {};
          z
        }\
        """);
  }

  @Test
  void bodies() {
    assertEquals("1", Printer.printBody(((Ast.Function) one("function () { 1 }")).body()));
    assertEquals("1;\n2;", Printer.printBody(((Ast.Function) one("closure () {1;2;}")).body()));
  }

  @Test
  void controlFlow() {
    prints("if (a) b else if (c) d", "if (a)\n{ b }\nelse\n{\n  if (c)\n  { d }\n}");
    prints("while| (a) { b; c }", "while| (a)\n{\n  b;\n  c\n}");
    prints("for, (var i = 0; i < 3; i++) a", "for, (var i = 0; i.'<'(3); i++)\n{ a }");
    prints("for (;;) {}", "for (;;)\n{}");
    prints("loop& {}".replace("&", "|"), "loop|\n{}");
    prints("every| (1s) a", "every| (1)\n{ a }");
    prints(
        "switch (a) { case 1: b; case [var x] if x: default: c, d }",
        """
        switch (a)
        {
          case 1:
            b
          case [var x] if x:
          default:
            c,
            d
        }\
        """);
    prints(
        "try { a } catch (var e if e.f) { b } catch {} else { c } finally { d }",
        """
        try
        { a }
        catch (var e if e.f)
        { b }
        catch
        {}
        else
        { c }
        finally
        { d }\
        """);
    prints(
        "at sync (e?(1, var x) if x ~ 1s) a onleave b",
        "at sync (e?(1, var x) if x ~ 1)\n{ a }\nonleave\n{ b }");
    prints("t: u: a = 1 time: 2s", "t: u: a = 1 time: 2");
    prints("assert { a; b == c }", "assert\n{\n  a;\n  b.'=='(c);\n}");
  }

  @Test
  void bracesOfOneLineWithinOnesOfSeveral() {
    prints(
        "{ {}; { { a } }; { { b; c } }; {;;}; {a,} }",
        """
        {
          {};
          { { a } };
          {
            {
              b;
              c
            }
          };
          {
            ;
            ;
          };
          { a, }
        }\
        """);
    prints("loop { if (a) {} else { function () {} } }", LOOP_OF_EMPTY_BODIES);
    prints("class A { b }", "class A\n{\n  b\n}");
    prints("class A {}", "class A\n{}");
    prints("{ class A { b } }", "{\n  class A\n  {\n    b\n  }\n}");
    prints("enum E {}", "enum E\n{\n}");
    prints("assert {}", "assert\n{\n}");
  }

  private static final String LOOP_OF_EMPTY_BODIES =
      """
      loop
      {
        if (a)
        {}
        else
        { function () {} }
      }\
      """;

  @Test
  void valuesOfSeveralLines() {
    prints(
        "function () { if (a) { f(1, [\"k\" => [2 => { x; y }]]); b } }",
        """
        function () {
          if (a)
          {
            f(1, [
              "k" => [
                2 => {
                  x;
                  y
                },
              ],
            ]);
            b
          }
        }\
        """);
    prints(
        "loop { switch (a) { case 1: { b; c }; case 2: case 3: {} default: } }",
        """
        loop
        {
          switch (a)
          {
            case 1:
              {
                b;
                c
              }
            case 2:
            case 3:
              {}
            default:
          }
        }\
        """);
    prints(
        "{ switch (a) { case [\"k\" => 1]: b } }",
        """
        {
          switch (a)
          {
            case [
            "k" => 1,
          ]:
              b
          }
        }\
        """);
  }

  @Test
  void linesFarToTheRight() {
    int depth = 50;
    var printed = new StringBuilder();
    for (int i = 0; i < depth; i++) {
      printed.append("  ".repeat(i)).append("{\n");
    }
    printed.append("  ".repeat(depth)).append("a;\n");
    printed.append("  ".repeat(depth)).append("b\n");
    for (int i = depth - 1; i >= 0; i--) {
      printed.append("  ".repeat(i)).append(i > 0 ? "}\n" : "}");
    }
    prints("{".repeat(depth) + "a; b" + "}".repeat(depth), printed.toString());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "package a.b\n{\n  var x = 1\n}",
        "import a.b.*",
        "import this.*",
        "var x : T = 1",
        "get foo() { 1 }",
        "set foo(var v) { x = v }",
        "try { a } catch { throw }",
        "function () { return 1 }",
        "loop { break }",
        "while (a) { continue }",
        "waituntil (a ~ 1)",
        "stopif (e?)\n{ a }",
        "freezeif (a)\n{ b }",
        "timeout (1)\n{ a }",
        "whenever (a)\n{ b }\nelse\n{ c }",
        "do (1)\n{ a }",
        "do\n{ a }.b",
        "watch(a)",
        "(var a, [1, var b]) = c",
        "a->b = 1",
        "a.b->c",
        "&f.g",
        "(a = 1).b",
        "(a && b).c",
        "a = 1 time: 2",
        "'if'.'\\n\\''('' = 1)",
        "enum E\n{\n  a,\n  b,\n}",
        "[ => ]",
        "(1,)",
        "function (var a : T = 1) {}",
        "e!(1).a",
        "{}.a",
        "class C",
        "x = (y = 1 time: 2) time: 3",
      })
  void isStable(String text) {
    Ast tree = one(text);
    assertEquals(Printer.print(tree), Printer.print(one(Printer.print(tree))));
  }

  @Test
  void keepsSmallStacks() throws InterruptedException {
    var failure = new Throwable[1];
    var thread =
        new Thread(
            null,
            () -> {
              for (String unit : List.of("f(", "{", "- ", "t: ", "1 + ", "a.", "if (1) 1 else ")) {
                for (int depth : new int[] {100, 200, 400, 700, 1400, 20_000}) {
                  String close = unit.equals("f(") ? ")" : unit.equals("{") ? "}" : "";
                  String text = unit.repeat(depth) + "a" + close.repeat(depth);
                  ParseResult parsed = UrbiParser.parse(text, null);
                  if (parsed.valid()) {
                    Printer.print(parsed.tree());
                  }
                }
              }
            },
            "small stack",
            1 << 20);
    thread.setUncaughtExceptionHandler((t, e) -> failure[0] = e);
    thread.start();
    thread.join();
    assertEquals(null, failure[0]);
  }
}
