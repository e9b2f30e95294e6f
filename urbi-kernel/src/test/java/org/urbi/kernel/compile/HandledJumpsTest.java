package org.urbi.kernel.compile;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.urbi.kernel.Evaluator.numbers;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Evaluator;

/** Jumps find what they leave, whatever expressions are around them. */
class HandledJumpsTest {
  private final Evaluator code = new Evaluator();

  @AfterEach
  void close() {
    code.close();
  }

  @Test
  void aLoopWithinAnExpressionSeesItsOwnJumpsAlone() {
    assertEquals(HandledJumps.LOOPS, HandledJumps.NOTHING.inLoop());
    assertEquals(HandledJumps.LOOPS, HandledJumps.LOOPS.inLoop());
    assertEquals(HandledJumps.ALL, HandledJumps.ALL.inLoop());
  }

  @Test
  void aReturnWithinAnExpressionLeavesTheFunction() {
    assertEquals(
        3.0,
        code.value(
            "function f() { var r = { for (var i : 9) { if (i == 3) return i }; 99 }; [r] }|;"
                + " f()"));
    assertEquals(5.0, code.value("function g() { [1, { if (true) return 5; 2 }]; 99 }|; g()"));
  }

  @Test
  void jumpsLeaveTheLoopWithinAnExpression() {
    assertEquals(
        numbers(3, 3),
        code.value(
            "{ var n = 0; var r = { while (true) { n += 1; if (n == 3) break }; n }; [r, n] }"));
    assertEquals(
        numbers(0, 2),
        code.value(
            "{ var seen = []; var r = { for (var i : 3) { if (i == 1) continue; seen << i }; seen };"
                + " r }"));
  }

  @Test
  void jumpsWithinAnExpressionLeaveTheLoopAround() {
    assertEquals(
        numbers(0, 1),
        code.value(
            "{ var seen = []; for (var i : 5) { var r = { if (i == 2) break; i }; seen << r };"
                + " seen }"));
    assertEquals(
        numbers(0, 1, 3, 4),
        code.value(
            "{ var seen = []; for (var i : 5) { var r = { if (i == 2) continue; i }; seen << r };"
                + " seen }"));
    assertEquals(
        numbers(2),
        code.value(
            "{ var n = 0; while (true) { n += 1; var r = [{ if (n == 2) break; n }] }; [n] }"));
  }

  @Test
  void jumpsOfHandlersStayThere() {
    assertEquals(
        numbers(2),
        code.value(
            "{ var seen = []; var e = Event.new;"
                + " function listen() { at (e?(var x)) { if (x == 1) return; seen << x } };"
                + " listen(); e!(1); e!(2); sleep(1ms); seen }"));
  }
}
