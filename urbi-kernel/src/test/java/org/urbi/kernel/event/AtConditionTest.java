package org.urbi.kernel.event;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;

/** What is done when a condition begins to hold (manual, "at"). */
class AtConditionTest {
  @Test
  void itIsDoneWhenTheConditionBeginsToHoldAndWhenItCeasesTo() {
    ConsoleTranscript.check(
        """
        var x = 0|;
        at (2 < x) echo("high") onleave echo("low");
        x = 2|;
        x = 3|;
        [00000000] *** high
        x = 4|;
        x = 1|;
        [00000000] *** low
        sleep(1ms);
        x = 0|;
        x = 9|;
        [00000001] *** high
        sleep(1ms);
        """);
  }

  @Test
  void whatHoldsFromTheStartIsDoneAtOnce() {
    ConsoleTranscript.check(
        """
        var x = 5|;
        at (2 < x) echo("high") onleave echo("low");
        [00000000] *** high
        sleep(1ms);
        x = 1|;
        [00000001] *** low
        sleep(1ms);
        """);
  }

  @Test
  void itMustHoldLongEnough() {
    ConsoleTranscript.check(
        """
        var x = 0|;
        at (2 < x ~ 1s) echo("high") onleave echo("low");
        x = 3|;
        sleep(500ms);
        x = 0|;
        sleep(2s);
        x = 3|;
        sleep(600ms);
        x = 4|;
        sleep(500ms);
        [00003500] *** high
        x = 0|;
        [00003600] *** low
        sleep(1s);
        """);
  }

  @Test
  void itHeldFromTheStartLongEnough() {
    ConsoleTranscript.check(
        """
        var x = 5|;
        at (2 < x ~ 1s) echo("high") onleave echo("low");
        sleep(2s);
        [00001000] *** high
        """);
  }

  @Test
  void aFrozenOneDoesNotSee() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var x = 0|;
        t: at (2 < x) echo("high") onleave echo("low");
        t.freeze;
        x = 3|;
        sleep(1s);
        t.unfreeze;
        x = 0|;
        x = 4|;
        [00001000] *** high
        sleep(1s);
        """);
  }

  @Test
  void aStoppedOneIsGone() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var x = 0|;
        t: at (2 < x ~ 1s) echo("never") onleave echo("never");
        x = 3|;
        sleep(500ms);
        t.stop;
        sleep(2s);
        x = 0|;
        sleep(1s);
        """);
  }

  @Test
  void itIsWatchedThroughObjectsListsAndFunctions() {
    ConsoleTranscript.check(
        """
        class Tank { var level = 1 }|;
        var tank = Tank.new|;
        var limits = [5]|;
        function full() { limits[0] < tank.level }|;
        at (full) echo("full") onleave echo("room");
        tank.level = 6|;
        [00000000] *** full
        sleep(1ms);
        limits[0] = 10|;
        [00000001] *** room
        sleep(1ms);
        limits << 3|;
        tank = Tank.new|;
        tank.level = 11|;
        [00000002] *** full
        sleep(1ms);
        tank = Tank.new|;
        [00000003] *** room
        sleep(1ms);
        """);
  }

  @Test
  void synchronousOnesAreDoneByWhoChanges() {
    ConsoleTranscript.check(
        """
        var x = 0|;
        at sync (x == 1) { sleep(1s); echo("in") } onleave { sleep(1s); echo("out") };
        { x = 1; echo("set") };
        [00001000] *** in
        [00001000] *** set
        { x = 0; echo("reset") };
        [00002000] *** out
        [00002000] *** reset
        """);
  }

  @Test
  void aConditionThatFailsIsToldAndForgotten() {
    ConsoleTranscript.check(
        """
        var x = 1|;
        at (1 / x == 1) echo("one") onleave echo("not one");
        [00000000] *** one
        sleep(1ms);
        x = 0|;
        [00000001:error] !!! 2.5-9: /: division by 0
        sleep(1ms);
        x = 2|;
        [00000002] *** not one
        sleep(1ms);
        x = 1|;
        [00000003] *** one
        sleep(1ms);
        """);
  }

  @Test
  void whatIsNoTruthIsTold() {
    ConsoleTranscript.check(
        """
        at (void) echo("never");
        [00000000:error] !!! 1.5-8: unexpected void
        var x = 1|;
        at ({ if (x == 1) true else void }) echo("in");
        [00000000] *** in
        x = 2|;
        [00000000:error] !!! 3.7-32: unexpected void
        sleep(1ms);
        """);
  }

  @Test
  void aConditionThatChangesWhatItReadsEnds() {
    ConsoleTranscript.check(
        """
        var x = 0|;
        var count = 0|;
        at ({ count++; x = x + 1; x > 1000 }) echo("never");
        x = 5|;
        sleep(1s);
        x;
        [00001000] 6
        count;
        [00001000] 2
        """);
  }

  @Test
  void conditionsOnTimePassing() {
    ConsoleTranscript.check(
        """
        var x = 0|;
        at (x > 1) echo("x") onleave echo("not x");
        timeout(2500ms) every|(1s) { x = x + 1 };
        [00001000] *** x
        x = 0|;
        [00002500] *** not x
        sleep(1s);
        """);
  }

  @Test
  void persistTellsWhetherSomethingHasHeldLong() {
    ConsoleTranscript.check(
        """
        var x = 0|;
        var p = persist(x == 1, 1s)|;
        p.val;
        [00000000] false
        x = 1|;
        sleep(500ms);
        p.val;
        [00000500] false
        sleep(600ms);
        p.val;
        [00001100] true
        x = 2|;
        p.val;
        [00001100] false
        x = 1|;
        sleep(500ms);
        x = 0|;
        sleep(1s);
        p.val;
        [00002600] false
        var q = persist(x == 0, 0s)|;
        q.val;
        [00002600] true
        x = 1|;
        q.val;
        [00002600] false
        """);
  }

  @Test
  void aStoppedPersistenceStaysAsItWas() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var x = 1|;
        var p = 0|;
        t: { p = persist(x == 1, 1s) };
        [00000000] Object_0x7f000010
        sleep(500ms);
        t.stop;
        sleep(1s);
        p.val;
        [00001500] false
        """);
  }

  @Test
  void whatChangesDuringTheFirstEvaluationIsSeen() {
    ConsoleTranscript.check(
        """
        var x = 0|;
        { at ({ var seen = x| sleep(1s)| seen == 5 }) echo("five") },
        sleep(500ms);
        x = 5|;
        sleep(2s);
        [00002000] *** five
        """);
  }

  @Test
  void oneThatHasCeasedToHoldDoesNotCeaseAgainWhenStopped() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var x = 0|;
        t: at (2 < x) echo("high") onleave echo("low");
        x = 3|;
        [00000000] *** high
        x = 0|;
        [00000000] *** low
        sleep(1s);
        t.stop;
        sleep(1s);
        """);
  }
}
