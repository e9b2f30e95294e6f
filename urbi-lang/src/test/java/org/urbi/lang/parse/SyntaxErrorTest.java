package org.urbi.lang.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The words and the places of errors and warnings. */
class SyntaxErrorTest {
  private static List<String> errors(String text) {
    return UrbiParser.parse(text, null).errors().stream()
        .map(e -> e.span().location() + ": " + e.message())
        .toList();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '@',
      quoteCharacter = '§',
      value = {
        "*;                              @ 1.1: unexpected *",
        "1.;                             @ 1.3: unexpected ;",
        "bar qux;                        @ 1.5-7: unexpected identifier",
        "{} )                            @ 1.4: unexpected ), expecting end of command or \",\" or"
            + " ;",
        "function 1() {}                 @ 1.10: unexpected float, expecting { or ( or identifier"
            + " or this",
        "&|                              @ 1.2: unexpected |, expecting identifier or new",
        "try 1                           @ 1.5: unexpected float, expecting {",
        "return 3;                       @ 1.1-8: return: outside a function",
        "if (true) break                 @ 1.11-15: break: outside a loop",
        "continue;                       @ 1.1-8: continue: outside a loop",
        "throw;                          @ 1.1-5: throw: outside a catch",
        "if (a) b; else c                @ 1.11-14: unexpected else",
        "f(1 + if (a) 3)                 @ 1.7-8: unexpected if",
        "1 in l in [false];              @ 1.8-9: unexpected in",
        "1 < 2 < 3                       @ 1.7: unexpected <",
        "a == b == c                     @ 1.8-9: unexpected ==",
        "class { };                      @ 1.10: unexpected ;",
        "var r = t: { 1 };               @ 1.1-5: declaration not allowed here",
        "{ a                             @ 1.4: unexpected end of file",
        "foreach ++                      @ 1.9-10: unexpected ++",
        "123foo;                         @ 1.1-6: invalid token: `123foo'",
        "12.3foo;                        @ 1.1-7: invalid token: `12.3foo'",
        "0xabcdefg                       @ 1.1-9: invalid token: `0xabcdefg'",
        "var int;                        @ 1.5-7: reserved symbol: `int'",
        "1 + var x;                      @ 1.5-9: declaration not allowed here",
        "f(var x);                       @ 1.3-7: declaration not allowed here",
        "[1, var x, 3];                  @ 1.5-9: declaration not allowed here",
        "var x = var y = 0;              @ 1.9-13: declaration not allowed here",
        "var x : tag;                    @ 1.7: unexpected :",
        "var f(1) = 3;                   @ 1.5-8: f(1) is not a valid lvalue",
        "var a.b->c = 1;                 @ 1.5-10: a.b->c is not a valid lvalue",
        "f(1) += 3;                      @ 1.1-4: f(1) is not a valid lvalue",
        "closure { 42 };                 @ 1.1-14: closure cannot be lazy",
        "function (x, y = 0, z) {};      @ 1.10-22: argument with no default value after"
            + " arguments with default value",
        "function f(a[], b) {}           @ 1.17: argument after list-argument",
        "try {} catch {} catch (var e){} @ 1.17-31: catch: exception already caught by a"
            + " previous clause",
        "for, (2) a;                     @ 1.1-4: invalid flavor: for,",
        "for& (;;) a;                    @ 1.1-4: invalid flavor: for&",
        "loop& a;                        @ 1.1-5: invalid flavor: loop&",
        "while& (a) b;                   @ 1.1-6: invalid flavor: while&",
        "every& (a) b;                   @ 1.1-6: invalid flavor: every&",
        "at| (a) b;                      @ 1.1-3: invalid flavor: at|",
        "at foo (e?) {};                 @ 1.1-14: unexpected `foo'",
        "at sync sync (e?) {};           @ 1.1-20: duplicate keyword: `sync'",
        "at sync async (e?) {};          @ 1.1-21: incompatible keywords: `sync' and `async'",
        "call.args                       @ 1.1-4: call: used outside any function",
        "[1, 2 => 3]                     @ 1.7-8: unexpected =>",
        "[1 => 2, 3]                     @ 1.11: unexpected ]",
        "x ~ 1s                          @ 1.3: unexpected ~",
        "\"abc                           @ 1.1-4: unexpected end of file in a string",
      })
  void tells(String text, String message) {
    assertEquals(List.of(message.replaceFirst(": ", ": syntax error: ")), errors(text));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '@',
      quoteCharacter = '§',
      value = {
        "#\u00c3\u0089t\u00c3\u00a9; @ 1.1 invalid character: `#'|1.2 invalid character: `\\xc3'"
            + "|1.3 invalid character: `\\x89'|1.5 invalid character: `\\xc3'"
            + "|1.6 invalid character: `\\xa9'",
        "\"\\h\\ \\777\\B(1)1\\B(1)(12\"; @ 1.1-3 invalid character after \\-escape: `h'"
            + "|1.1-5 invalid character after \\-escape: ` '"
            + "|1.1-9 invalid number after \\-escape: `777'"
            + "|1.1-15 invalid \\B(SIZE)(CONTENTS) escape: `\\B(1)1'"
            + "|1.1-22 unexpected '2' for closing \\B, expected ')'",
      })
  void tellsAll(String text, String messages) {
    List<String> expected =
        Stream.of(messages.split("\\|")).map(m -> m.replaceFirst(" ", ": syntax error: ")).toList();
    assertEquals(expected, errors(text));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '@',
      quoteCharacter = '§',
      value = {
        "foreach (3) a;         @ 1.1-7: `foreach' is deprecated, use `for'",
        "assert(1m == 60s);     @ 1.8-9: `1m' is deprecated, use `1min'",
        "self;                  @ 1.1-4: `self' is deprecated, use `this'",
        "var b = new a(444);    @ 1.9-18: `new Obj(x)' is deprecated, use `Obj.new(x)'",
        "x = 1 speed: 1 speed: 2 @ 1.16-23: modifier redefined: speed",
        "x'dd;                  @ 1.1-4: `x'dd' is deprecated, use `x.'\\'dd''.",
        "if (x);                @ 1.7: implicit empty statement, use `{}'",
      })
  void warns(String text, String message) {
    ParseResult parsed = UrbiParser.parse(text, null);
    assertEquals(List.of(), parsed.errors());
    assertEquals(
        List.of(message),
        parsed.warnings().stream().map(w -> w.span().location() + ": " + w.message()).toList());
  }
}
