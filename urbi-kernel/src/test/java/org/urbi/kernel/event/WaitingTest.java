package org.urbi.kernel.event;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;

/**
 * Code that goes on again and again, or waits for its time (manual, "whenever", "waituntil",
 * "every").
 */
class WaitingTest {
  @Test
  void wheneverRepeatsAsLongAsTheConditionHolds() {
    ConsoleTranscript.check(
        """
        var x = 0|;
        whenever (x < 2) { echo("less"); sleep(1s) } else { echo("enough"); sleep(1s) },
        [00000000] *** less
        sleep(1500ms);
        [00001000] *** less
        x = 3|;
        [00001500] *** enough
        sleep(1800ms);
        [00002500] *** enough
        x = 1|;
        [00003300] *** less
        sleep(1200ms);
        [00004300] *** less
        """);
  }

  @Test
  void wheneverNeedNotHaveAnElse() {
    ConsoleTranscript.check(
        """
        var x = 5|;
        whenever (x < 2) { echo("less"); sleep(1s) },
        sleep(1500ms);
        x = 1|;
        [00001500] *** less
        sleep(1200ms);
        [00002500] *** less
        x = 7|;
        sleep(2s);
        """);
  }

  @Test
  void wheneverWaitsUntilTheConditionHasHeld() {
    ConsoleTranscript.check(
        """
        var x = 0|;
        whenever (x == 1 ~ 1s) { echo("held"); sleep(1s) },
        x = 1|;
        sleep(500ms);
        x = 0|;
        sleep(1s);
        x = 1|;
        sleep(2500ms);
        [00002500] *** held
        [00003500] *** held
        x = 2|;
        sleep(2s);
        """);
  }

  @Test
  void wheneverOnAnEventRepeatsWhileItLasts() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        whenever (e?(var x)) { echo("on " + x); sleep(1s) } else { echo("off"); sleep(1s) },
        [00000000] *** off
        sleep(1500ms);
        [00001000] *** off
        e!(1);
        [00001500] *** off
        [00001500] *** on 1
        sleep(1500ms);
        [00002500] *** off
        e!(2) ~ 2500ms;
        [00003000] *** on 2
        [00004000] *** on 2
        [00005000] *** on 2
        [00005500] *** off
        sleep(2s);
        [00006500] *** off
        [00007500] *** off
        """);
  }

  @Test
  void wheneverOnAnEventHasAGuardAndADuration() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        whenever (e?(var x) if 5 < x ~ 1s) { echo("on " + x); sleep(1s) },
        e!(6);
        e!(6) ~ 500ms;
        e!(4) ~ 3s;
        e!(7) ~ 2500ms;
        [00004500] *** on 7
        [00005500] *** on 7
        sleep(2s);
        """);
  }

  @Test
  void twoEmissionsAtATimeAreFollowedBoth() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        whenever (e?(var x)) { echo("on " + x); sleep(1s) } else { echo("off"); sleep(10s) },
        [00000000] *** off
        sleep(100ms);
        e!(1) ~ 3s, e!(2) ~ 1500ms, sleep(5s);
        [00000100] *** on 1
        [00000100] *** on 2
        [00001100] *** on 1
        [00001100] *** on 2
        [00002100] *** on 1
        [00003100] *** off
        """);
  }

  @Test
  void wheneverIsStoppedAndFrozenByItsTag() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var x = 1|;
        t: whenever (x == 1) { echo("on"); sleep(1s) } else { echo("off"); sleep(1s) },
        [00000000] *** on
        sleep(1500ms);
        [00001000] *** on
        t.freeze;
        sleep(1s);
        t.unfreeze;
        sleep(600ms);
        [00003000] *** on
        t.stop;
        sleep(2s);
        x = 2|;
        sleep(2s);
        """);
  }

  @Test
  void wheneverOnAnEventIsStoppedByItsTag() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var e = Event.new|;
        t: whenever (e? ~ 1s) { echo("on"); sleep(1s) },
        e! ~ 10s,
        sleep(2500ms);
        [00001000] *** on
        [00002000] *** on
        t.stop;
        sleep(3s);
        e.hasSubscribers;
        [00005500] false
        t: whenever (e? ~ 1s) { echo("never"); sleep(1s) },
        sleep(500ms);
        t.stop;
        sleep(5s);
        t: whenever (e?) { echo("never"); sleep(1s) },
        t.freeze;
        e!;
        t.unfreeze;
        sleep(2s);
        """);
  }

  @Test
  void wheneverNeedsATruth() {
    ConsoleTranscript.check(
        """
        whenever (1 / 0) echo("never");
        [00000000:error] !!! 1.11-15: /: division by 0
        whenever (void) echo("never");
        [00000000:error] !!! 2.11-14: unexpected void
        var x = 1|;
        whenever (1 / x == 5) echo("never");
        x = 0|;
        [00000000:error] !!! 4.11-15: /: division by 0
        sleep(1s);
        whenever (1?) echo("never");
        [00001000:error] !!! 7.11: ?: this: unexpected 1, expected an Event
        """);
  }

  @Test
  void waituntilWaitsForACondition() {
    ConsoleTranscript.check(
        """
        var x = 0|;
        { waituntil (x == 2); echo("two") },
        sleep(1s);
        x = 1|;
        sleep(1s);
        x = 2|;
        [00002000] *** two
        sleep(1s);
        { waituntil (x == 2); echo("already") };
        [00003000] *** already
        """);
  }

  @Test
  void waituntilWaitsUntilItHasHeld() {
    ConsoleTranscript.check(
        """
        var x = 0|;
        { waituntil (x == 2 ~ 1s); echo("held") },
        x = 2|;
        sleep(500ms);
        x = 1|;
        sleep(2s);
        x = 2|;
        sleep(2s);
        [00003500] *** held
        x = 0|;
        """);
  }

  @Test
  void waituntilWaitsForAnEvent() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        { waituntil (e?(var x) if 2 < x); echo("got " + x) },
        e!(1);
        e!(3);
        [00000000] *** got 3
        e!(4);
        sleep(1s);
        e.hasSubscribers;
        [00001000] false
        { waituntil (e? ~ 1s); echo("lasted") },
        e! ~ 500ms;
        sleep(1s);
        e! ~ 3s;
        [00003500] *** lasted
        { waituntil (1?); echo("never") };
        [00005500:error] !!! 12.14: ?: this: unexpected 1, expected an Event
        { waituntil (1 / 0); echo("never") };
        [00005500:error] !!! 13.14-18: /: division by 0
        { waituntil (void); echo("never") };
        [00005500:error] !!! 14.14-17: unexpected void
        """);
  }

  @Test
  void waituntilHearsOfAnEmissionThatLasts() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        e!(8) ~ 3s,
        sleep(1s);
        { waituntil (e?(var x)); echo("got " + x) };
        [00001000] *** got 8
        """);
  }

  @Test
  void whoWaitsIsStopped() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var e = Event.new|;
        var x = 0|;
        t: { waituntil (e?); echo("never") },
        t: { waituntil (x == 1 ~ 1s); echo("never") },
        sleep(1s);
        x = 1|;
        sleep(500ms);
        t.stop;
        e.hasSubscribers;
        [00001500] false
        e!;
        sleep(2s);
        """);
  }

  @Test
  void whoIsFrozenDoesNotHear() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var e = Event.new|;
        t: { waituntil (e?(var x)); echo("got " + x) },
        sleep(1s);
        t.freeze;
        e!(1);
        sleep(1s);
        t.unfreeze;
        sleep(1s);
        e!(2);
        [00003000] *** got 2
        sleep(1s);
        """);
  }

  @Test
  void watchTellsEachValue() {
    ConsoleTranscript.check(
        """
        var x = 0|;
        var e = watch(x + 1)|;
        at (e?(var v)) echo("now " + v);
        x = 1|;
        [00000000] *** now 2
        x = 2|;
        [00000000] *** now 3
        x = 2|;
        [00000000] *** now 3
        sleep(1ms);
        """);
  }

  @Test
  void aWatchEndsWithItsTag() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var x = 0|;
        var e = 0|;
        t: { e = watch(x)|; };
        at (e?(var v)) echo("now " + v);
        x = 1|;
        [00000000] *** now 1
        sleep(1ms);
        t.stop;
        x = 2|;
        sleep(1ms);
        """);
  }

  @Test
  void turnsOfEveryBeginAtEqualIntervals() {
    ConsoleTranscript.check(
        """
        timeout(3500ms) every (1s) { echo("turn"); sleep(1500ms); echo("end") };
        [00000000] *** turn
        [00001000] *** turn
        [00001500] *** end
        [00002000] *** turn
        [00002500] *** end
        [00003000] *** turn
        sleep(2s);
        timeout(5500ms) every| (1s) { echo("turn"); sleep(1500ms); echo("end") };
        [00005500] *** turn
        [00007000] *** end
        [00007000] *** turn
        [00008500] *** end
        [00008500] *** turn
        [00010000] *** end
        [00010000] *** turn
        timeout(2500ms) every, (1s) { echo("turn"); sleep(1500ms); echo("end") };
        [00011000] *** turn
        [00012000] *** turn
        [00012500] *** end
        [00013000] *** turn
        sleep(2s);
        """);
  }

  @Test
  void everyHasItsSenseOfTime() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        t: every| (1s) echo("tick"),
        [00000000] *** tick
        sleep(1500ms);
        [00001000] *** tick
        t.freeze;
        sleep(2s);
        t.unfreeze;
        sleep(2s);
        [00004000] *** tick
        [00005000] *** tick
        t.stop;
        sleep(2s);
        """);
  }

  @Test
  void aPeriodIsANumberAndMayChange() {
    ConsoleTranscript.check(
        """
        var n = 0|;
        timeout(1s) every| (0) { n++; if (n == 3) break };
        n;
        [00000000] 3
        every| (-1s) { n++; if (n == 6) break };
        n;
        [00000000] 6
        every| ("often") echo("never");
        [00000000:error] !!! 6.9-15: duration: argument 1: unexpected "often", expected a Float
        every| (void) echo("never");
        [00000000:error] !!! 7.9-12: duration: argument 1: unexpected void, expected a Float
        var p = 1s|;
        timeout(6500ms) every| (p) { echo("turn"); p = p * 2 };
        [00000000] *** turn
        [00001000] *** turn
        [00003000] *** turn
        """);
  }

  @Test
  void aTurnThatLeavesEndsTheLoop() {
    ConsoleTranscript.check(
        """
        every| (1s) { echo("turn"); break };
        [00000000] *** turn
        for| (var i : [1, 2]) every| (1s) { echo("turn " + i); break };
        [00000000] *** turn 1
        [00000000] *** turn 2
        function f() { every| (1s) { return 5 } }|;
        f;
        [00000000] 5
        every| (1s) { throw Exception.new("out") };
        [00000000:error] !!! 5.15-40: out
        echo("on");
        [00000000] *** on
        """);
  }
}
