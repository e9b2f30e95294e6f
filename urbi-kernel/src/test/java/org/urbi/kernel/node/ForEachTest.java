package org.urbi.kernel.node;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.kernel.Evaluator.numbers;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.Evaluator;

/** What a loop goes through, in turns, at once, and by an {@code each} of its own. */
class ForEachTest {
  /** A range that is neither a number nor a list. */
  private static final String OWN =
      "class Three { function each(f) { f(1); f(2); f(3) };"
          + " function 'each|'(f) { f(1)| f(2)| f(3) } }|; var three = Three.new|;";

  private final Evaluator code = new Evaluator();

  @BeforeEach
  void defineRange() {
    code.value(OWN);
  }

  @AfterEach
  void close() {
    code.close();
  }

  private Object seen(String loop) {
    return code.value("{ var seen = []; " + loop + "; seen }");
  }

  @ParameterizedTest
  @ValueSource(strings = {"for", "for|"})
  void eachElementHasItsTurn(String loop) {
    assertEquals(numbers(0, 1, 2), seen(loop + " (var i : 3) seen << i"));
    assertEquals(numbers(5, 7), seen(loop + " (var i : [5, 7]) seen << i"));
    assertEquals(numbers(1, 2, 3), seen(loop + " (var i : three) seen << i"));
    assertEquals(List.of(), seen(loop + " (var i : 0) seen << i"));
    assertEquals(List.of(), seen(loop + " (var i : -2) seen << i"));
    assertEquals(List.of(), seen(loop + " (var i : []) seen << i"));
    assertEquals(numbers(0, 1, 2), seen(loop + " (var i : 2.5) seen << i"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"3", "[0, 1, 2]", "three"})
  void jumpsEndALoopOrATurn(String range) {
    boolean own = range.equals("three");
    assertEquals(
        own ? numbers(1) : numbers(0, 1),
        seen("for (var i : " + range + ") { if (i == 2) break; seen << i }"));
    assertEquals(
        own ? numbers(2, 3) : numbers(0, 2),
        seen("for (var i : " + range + ") { if (i == 1) continue; seen << i }"));
    assertEquals(
        20.0,
        code.value(
            "function f() { for (var i : "
                + range
                + ") { if (i == 2) return i * 10 }; 99 }|; f()"));
  }

  @Test
  void whatALoopDoesToItsListDoesNotMatterToIt() {
    assertEquals(numbers(6), code.value("{ var l = [1, 2, 3]; for (var x : l) l << x; [l.size] }"));
    assertEquals(
        numbers(1, 2, 3), seen("var l = [1, 2, 3]; for (var x : l) { seen << x; l.clear }"));
  }

  @Test
  void anEachOfItsOwnIsAsked() {
    assertEquals(
        List.of("own"),
        seen("var l = [1, 2]; function l.each(f) { f(\"own\") }; for (var x : l) seen << x"));
    assertEquals(numbers(1, 2), seen("var l = [1, 2]; for (var x : l) seen << x"));
  }

  @Test
  void othersRunBetweenTurnsOrNot() {
    assertEquals(
        List.of("a", "b", "a", "b"),
        code.value(
            "{ var seen = []; { for (var i : 2) seen << \"a\" } & { for (var i : 2) seen << \"b\" };"
                + " seen }"));
    assertEquals(
        List.of("a", "a", "b", "b"),
        code.value(
            "{ var seen = []; { for| (var i : 2) seen << \"a\" } & { for| (var i : 2) seen << \"b\" };"
                + " seen }"));
  }

  @Test
  void turnsThatRunAtOnceAreAwaited() {
    assertEquals(
        numbers(10, 20, 30, 0),
        code.value(
            "{ var seen = []; for& (var x : [30, 10, 20]) { sleep(x * 1ms) | seen << x };"
                + " seen << 0; seen }"));
    assertEquals(
        numbers(2, 1, 0),
        code.value(
            "{ var seen = []; for& (var i : 3) { sleep((3 - i) * 1ms) | seen << i }; seen }"));
  }

  @Test
  void anErrorOfATurnEndsTheLoop() {
    assertEquals(
        List.of(numbers(0, 1), 1.0),
        code.value(
            "{ var seen = []; var thrown = 0; try { for (var i : 3) { seen << i;"
                + " if (i == 1) throw i } } catch (var e) { thrown = e }; [seen, thrown] }"));
  }

  @Test
  void aLoopHasNoValue() {
    assertNull(code.value("for (var i : 3) i"));
    assertNull(code.value("for (var i : [1]) { if (i == 1) break }"));
  }

  @Test
  void whatCannotBeGoneThroughIsTold() {
    String told = code.error("for (var i : true) {}").getMessage();
    assertTrue(told.contains("lookup failed: each"), told);
    String two =
        code.error("class Two { function each(f) { f(1, 2) } }|; for (var i : Two.new) {}")
            .getMessage();
    assertTrue(two.contains("expected 1 argument, given 2"), two);
  }
}
