package org.urbi.kernel.compile;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.kernel.Evaluator.numbers;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Evaluator;

/** What stands on the left of an assignment (manual, "Assignments"). */
class AssignmentsTest {
  private final Evaluator code = new Evaluator();

  @AfterEach
  void close() {
    code.close();
  }

  private void assertFails(String source, String message) {
    String told = code.error(source).getMessage();
    assertTrue(told.contains(message), told);
  }

  @Test
  void aNameIsTheVariableOfTheNearestScope() {
    assertEquals(numbers(3, 2), code.value("{ var n = 1; { var n = 2; n = 3; [n, 2] } }"));
    assertEquals(numbers(1, 4), code.value("var s = 1|; { var l = 2; { l = 4 }; [s, l] }"));
    assertEquals(5.0, code.value("var slot = 1|; { slot = 5 }; slot"));
    assertFails("{ nowhere = 1 }", "lookup failed: nowhere");
  }

  @Test
  void aSlotOfAnObjectIsItsOwn() {
    assertEquals(
        numbers(1, 2),
        code.value(
            "class Arm { var angle = 1 }|; var left = Arm.new|; left.angle = 2|;"
                + " [Arm.new.angle, left.angle]"));
    assertFails("left = Object.new; left.missing = 1", "lookup failed: missing");
    assertFails("const var limit = 1|; limit = 2", "cannot modify const slot");
  }

  @Test
  void anElementIsSetByItsContainer() {
    assertEquals(numbers(1, 7, 3), code.value("{ var l = [1, 2, 3]; l[1] = 7; l }"));
    assertEquals(
        Map.of("a", 2.0, "b", 3.0),
        code.value("{ var d = [\"a\" => 1]; d[\"a\"] = 2; d[\"b\"] = 3; d }"));
    assertEquals(
        List.of(numbers(1, 2, 3), numbers(6)),
        code.value(
            "class Grid { var set = [] ; function '[]='(i, j, v) { set = [i, j, v] | 2 * v } }|;"
                + " var g = Grid.new|; { var value = g[1, 2] = 3; [g.set, [value]] }"));
  }

  @Test
  void variablesInAPatternAreAssigned() {
    assertEquals(
        numbers(2, 1),
        code.value("{ var a = 0; var b = 0; [a, b] = [1, 2]; [a, b] = [b, a]; [a, b] }"));
    assertEquals(
        numbers(4, 5), code.value("{ var a = 0; var b = 0; (a, [b, 3]) = (4, [5, 3]); [a, b] }"));
    assertEquals(numbers(1, 2), code.value("{ [var a, var b] = [1, 2]; [a, b] }"));
  }

  @Test
  void whatIsNoVariableInAPatternIsCompared() {
    assertFails("{ var a = 0; [a, 1] = [2, 3] }", "pattern did not match");
    assertFails("{ var a = 0; [a] = [1, 2] }", "pattern did not match");
    assertFails("{ var a = 0; (a, 2) = [1, 2] }", "pattern did not match");
  }

  @Test
  void thePartsOfACompoundAssignmentAreEvaluatedOnce() {
    assertEquals(
        List.of(numbers(1, 12), numbers(1)),
        code.value(
            "{ var l = [1, 2]; var calls = 0; function index() { calls += 1; 1 };"
                + " l[index()] += 10; [l, [calls]] }"));
    assertEquals(
        numbers(6, 1),
        code.value(
            "class Holder { var n = 1 }|; { var h = Holder.new; var calls = 0;"
                + " function holder() { calls += 1; h }; holder().n += 5; [h.n, calls] }"));
  }

  @Test
  void aCompoundAssignmentAsksTheOperator() {
    assertEquals(
        numbers(7, 6, 18, 9), code.value("{ var x = 5; [x += 2, x -= 1, x *= 3, x /= 2] }"));
    assertEquals(
        "grown by 3",
        code.value(
            "class Grower { function '+='(by) { \"grown by \" + by } }|;"
                + " { var g = Grower.new; g += 3; g }"));
  }

  @Test
  void aPostfixGivesTheFormerValue() {
    assertEquals(numbers(1, 2), code.value("{ var x = 1; [x++, x] }"));
    assertEquals(numbers(1, 0), code.value("{ var x = 1; [x--, x] }"));
    assertEquals(numbers(4, 5), code.value("var slot = 4|; [slot++, slot]"));
    assertEquals(List.of(2.0, numbers(1, 3)), code.value("{ var l = [1, 2]; [l[1]++, l] }"));
  }

  @Test
  void aPropertyIsReadAndWritten() {
    assertEquals(7.0, code.value("var p = 1|; p->tick = 3|; p->tick += 4|; p->tick"));
    assertEquals(1.0, code.value("p"));
  }

  @Test
  void aTrajectoryEndsAtItsTarget() {
    assertEquals(
        numbers(10, 1),
        code.value("var t = 0|; { var begin = time; t = 10 time: 1s; [t, (time - begin).round] }"));
    assertEquals(4.0, code.value("{ var l = 0; l = 4 time: 1s; l }"));
  }
}
