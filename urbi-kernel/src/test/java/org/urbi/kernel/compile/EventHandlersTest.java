package org.urbi.kernel.compile;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.urbi.kernel.Evaluator.numbers;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Evaluator;

/** What code of handlers sees of the code around it, and what it waits for. */
class EventHandlersTest {
  private final Evaluator code = new Evaluator();

  @AfterEach
  void close() {
    code.close();
  }

  @Test
  void aTagIsMadeWhereItIsFirstUsed() {
    assertEquals(true, code.value("fresh: 7; fresh.isA(Tag)"));
    assertEquals(true, code.value("fresh.part: 7; fresh.part.isA(Tag)"));
    assertEquals(
        numbers(1),
        code.value(
            "{ var seen = []; var t = Tag.new; t: { seen << 1; t.stop; seen << 2 }; seen }"));
  }

  @Test
  void allClausesSeeTheVariablesOfThePattern() {
    assertEquals(
        List.of(numbers(1, 2), "left 1"),
        code.value(
            "{ var seen = []; var e = Event.new;"
                + " at (e?(var x, var y) if x < y) seen << [x, y] onleave seen << (\"left \" + x);"
                + " e!(1, 2); e!(3, 2); e!(1); sleep(1ms); seen }"));
  }

  @Test
  void aHandlerHasTheVariablesOfItsEmission() {
    assertEquals(
        numbers(1, 2),
        code.value(
            "{ var seen = []; var e = Event.new;"
                + " at (e?(var x)) { sleep(10ms); seen << x };"
                + " e!(1); sleep(5ms); e!(2); sleep(20ms); seen }"));
  }

  @Test
  void aConditionFollowsLocalVariables() {
    assertEquals(
        List.of("above", "below"),
        code.value(
            "{ var seen = []; var n = 0; at (3 < n) seen << \"above\" onleave seen << \"below\";"
                + " n = 5; sleep(1ms); n = 6; sleep(1ms); n = 1; sleep(1ms); seen }"));
  }

  @Test
  void aConditionMayHaveToLast() {
    assertEquals(
        numbers(0, 1),
        code.value(
            "{ var n = 0; var on = false; at (on ~ 50ms) n += 1;"
                + " on = true; sleep(20ms); on = false; sleep(100ms); var before = n;"
                + " on = true; sleep(100ms); [before, n] }"));
  }

  @Test
  void waituntilSeesWhatOthersAssign() {
    assertEquals(5.0, code.value("{ var x = 0; { sleep(20ms) | x = 5 }, waituntil (x == 5); x }"));
  }

  @Test
  void waituntilBindsThePayload() {
    assertEquals(
        42.0,
        code.value(
            "{ var e = Event.new; { sleep(10ms) | e!(1, 2) | e!(42) },"
                + " waituntil (e?(var v)); v }"));
  }

  @Test
  void aPeriodIsRepeatedUntilItsTagStops() {
    assertEquals(5.0, code.value("{ var n = 0; timeout (95ms) every (20ms) n += 1; n }"));
    assertEquals(3.0, code.value("{ var n = 0; every| (10ms) { n += 1; if (n == 3) break }; n }"));
  }

  @Test
  void aTimeoutEndsItsCodeAlone() {
    assertEquals(
        numbers(1, 3),
        code.value(
            "{ var seen = []; timeout (10ms) { seen << 1; sleep(1h); seen << 2 }; seen << 3; seen }"));
  }

  @Test
  void stopifEndsCodeWhenItsConditionHolds() {
    assertEquals(
        numbers(1, 3),
        code.value(
            "{ var seen = []; var on = false; { sleep(10ms) | on = true },"
                + " stopif (on) { seen << 1; sleep(1h); seen << 2 }; seen << 3; seen }"));
    // The first step is done in any case.
    assertEquals(
        numbers(1), code.value("{ var seen = []; stopif (true) { seen << 1; seen << 2 }; seen }"));
  }

  @Test
  void freezeifHoldsCodeUp() {
    assertEquals(
        true,
        code.value(
            "{ var on = false; var begin = time;"
                + " { sleep(10ms) | on = true | sleep(100ms) | on = false },"
                + " freezeif (on) sleep(20ms); 0.1 < time - begin }"));
  }

  @Test
  void wheneverGoesOnAsLongAsItsConditionHolds() {
    assertEquals(
        List.of(true, true),
        code.value(
            "{ var on = true; var n = 0; var m = 0; var t = Tag.new;"
                + " t: whenever (on) { n += 1; sleep(10ms) } else { m += 1; sleep(10ms) },"
                + " sleep(35ms); var before = m; on = false; sleep(35ms); t.stop;"
                + " [1 < n && before == 0, 1 < m] }"));
  }
}
