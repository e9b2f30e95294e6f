package org.urbi.kernel.node;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.kernel.Evaluator.numbers;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Evaluator;
import org.urbi.lang.problem.SyntaxProblem;

/** What jumps leave, and with what value. */
class JumpsTest {
  private final Evaluator code = new Evaluator();

  @AfterEach
  void close() {
    code.close();
  }

  @Test
  void aReturnEndsItsFunctionWithItsValue() {
    assertEquals(1.0, code.value("function f() { return 1; 2 }|; f()"));
    assertNull(code.value("function g() { return; 2 }|; g()"));
    assertEquals(
        numbers(0, 7),
        code.value(
            "function h() { while (true) { for (var i : 5) { if (i == 2) return 7 } } }|;"
                + " [0, h()]"));
  }

  @Test
  void aReturnOfAClosureLeavesTheFunctionAroundIt() {
    assertEquals(
        20.0,
        code.value(
            "function f() { [1, 2, 3].each(closure (x) { if (x == 2) return x * 10 }); 99 }|; f()"));
    assertEquals(
        99.0,
        code.value(
            "function g() { [1, 2, 3].each(function (x) { if (x == 2) return x * 10 }); 99 }|;"
                + " g()"));
  }

  @Test
  void aReturnOfAClosureWhoseFunctionHasEndedLeavesTheClosureAlone() {
    assertEquals(
        numbers(5, 6),
        code.value(
            "function make() { closure (x) { return x; 0 } }|; var c = make()|; [c(5), c(6)]"));
  }

  @Test
  void loopsAreLeftOneByOne() {
    assertEquals(
        numbers(0, 10, 20),
        code.value(
            "{ var seen = []; for (var i : 3) { for (var j : 3) { if (j == 1) break;"
                + " seen << i * 10 + j } }; seen }"));
    assertEquals(
        numbers(0, 2),
        code.value("{ var seen = []; for (var i : 3) { if (i == 1) continue; seen << i }; seen }"));
    assertEquals(
        numbers(1, 3),
        code.value(
            "{ var seen = []; var i = 0; while (i < 3) { i++; if (i == 2) continue; seen << i };"
                + " seen }"));
  }

  @Test
  void anyValueCanBeThrown() {
    assertEquals(42.0, code.error("throw 42").value());
    assertEquals("42", code.error("throw \"4\" + \"2\"").value());
    String told = code.error("throw Exception.new(\"my own\")").getMessage();
    assertTrue(told.endsWith("my own"), told);
  }

  @Test
  void whatIsThrownAgainKeepsItsPlace() {
    var first = code.error("function f() {\n  throw Exception.new(\"first\")\n}|;\nf()");
    var again =
        code.error(
            "function g() {\n  throw Exception.new(\"first\")\n}|;\n"
                + "try { g() } catch (var e) {\n  throw\n}");
    assertEquals(2, first.location().line());
    assertEquals(2, again.location().line());
  }

  @Test
  void nothingCanBeThrownAgainWhereNothingWasCaught() {
    String told = code.error("function f() { throw }|; f()").getMessage();
    assertTrue(told.endsWith(SyntaxProblem.THROW_OUTSIDE.text()), told);
  }
}
