package org.urbi.kernel.node;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.kernel.Evaluator.numbers;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Evaluator;
import org.urbi.kernel.embed.UrbiError;

/** What an activation of a function has of its own, what it shares, and who has called it. */
class FrameTest {
  private static final String DEEP =
      "function deep(n) { if (n == 0) throw Exception.new(\"end\"); deep(n - 1) }|; ";

  private final Evaluator code = new Evaluator();

  @AfterEach
  void close() {
    code.close();
  }

  private List<String> callers(String source) {
    return code.error(source).backtrace().stream().map(UrbiError.Call::name).toList();
  }

  @Test
  void eachActivationHasItsOwnVariables() {
    assertEquals(
        24.0, code.value("function f(n) { var k = n; if (n < 2) 1 else f(n - 1) * k }|; f(4)"));
  }

  @Test
  void callersAreToldInnermostFirst() {
    assertEquals(
        List.of("inner", "outer"),
        callers(
            "function inner() { throw Exception.new(\"x\") }|;"
                + " function outer() { inner() }|; outer()"));
    assertEquals(List.of("deep", "deep", "deep"), callers(DEEP + "deep(2)"));
  }

  @Test
  void ofARunawayRecursionBothEndsAreTold() {
    List<String> calls = callers(DEEP + "deep(299)");
    assertEquals(151, calls.size());
    assertEquals("(150 more calls)", calls.get(100));
    assertEquals(150, calls.stream().filter("deep"::equals).count());
    assertEquals(150, callers(DEEP.replace("deep", "less") + "less(149)").size());
  }

  @Test
  void theBodyOfDoHasAnotherThisAndTheSameVariables() {
    assertEquals(
        numbers(7, 9, 5),
        code.value(
            "{ var k = 3; var o = Object.new; var o.n = 4; var r = 0;"
                + " do (o) { r = n + k; k = 9; n = 5 }; [r, k, o.n] }"));
  }

  @Test
  void codeAtOnceSharesTheVariables() {
    assertEquals(
        numbers(2, 1), code.value("{ var n = 0; var m = 0; { n = 2 } & { m = 1 }; [n, m] }"));
    assertEquals(
        5.0, code.value("function f() { var n = 1; { sleep(1ms) | n = 5 }, sleep(2ms); n }|; f()"));
  }

  @Test
  void closuresKeepTheVariablesOfTheirActivation() {
    assertEquals(
        numbers(11, 101, 12),
        code.value(
            "function counter(n) { closure () { n += 1 } }|;"
                + " var a = counter(10)|; var b = counter(100)|; [a(), b(), a()]"));
  }

  @Test
  void argumentsCanBeEvaluatedWhereTheyStand() {
    assertEquals(
        numbers(1, 1, 2),
        code.value(
            "function lazily { [call.evalArgAt(0), call.evalArgAt(0)] }|;"
                + " { var n = 0; var r = lazily(n += 1); [r[0], r[0], n] }"));
  }

  @Test
  void anErrorIsToldWhereItWasThrown() {
    UrbiError error = code.error("function f() {\n  1 + nowhere\n}|;\nf()");
    assertEquals(2, error.location().line());
    assertEquals(4, error.backtrace().getFirst().location().line());
    assertTrue(error.getMessage().endsWith("lookup failed: nowhere"), error::getMessage);
  }
}
