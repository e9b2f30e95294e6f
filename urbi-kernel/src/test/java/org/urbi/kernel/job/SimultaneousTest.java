package org.urbi.kernel.job;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;

/** What happens at the same time happens in the order in which it was asked for. */
class SimultaneousTest {
  @Test
  void sleepersWakeInTheirOrder() {
    ConsoleTranscript.check(
        """
        { sleep(1s); echo("a") }, { sleep(1s); echo("b") }, { sleep(1s); echo("c") },
        sleep(2s);
        [00001000] *** a
        [00001000] *** b
        [00001000] *** c
        { sleep(2s); echo("d") }, { sleep(1s); sleep(1s); echo("e") }, { sleep(500ms); sleep(1500ms); echo("f") },
        sleep(3s);
        [00004000] *** d
        [00004000] *** f
        [00004000] *** e
        """);
  }

  @Test
  void timersOfAllKindsFireInTheirOrder() {
    ConsoleTranscript.check(
        """
        var x = 1|;
        var e = Event.new|;
        at (x == 1 ~ 1s) echo("at");
        { sleep(1s); echo("sleep") }, { timeout(1s) { sleep(5s) }; echo("timeout") }, { waituntil (x == 1 ~ 1s); echo("waituntil") },
        sleep(2s);
        [00001000] *** at
        [00001000] *** sleep
        [00001000] *** timeout
        [00001000] *** waituntil
        """);
  }

  /** On a busy machine it would not catch up. */
  @Test
  void aTurnOfEveryThatIsDueTakesOneCycle() {
    ConsoleTranscript.check(
        """
        var n = 0|;
        var m = 0|;
        every (0s) n += 1, loop m += 1,
        sleep(10ms);
        0.9 * m < n && n < 1.1 * m;
        [00000010] true
        """);
  }

  @Test
  void turnsOfSeveralLoopsKeepTheirOrder() {
    ConsoleTranscript.check(
        """
        every| (1s) echo("a"), every| (1s) echo("b"), every| (500ms) echo("c"),
        [00000000] *** a
        [00000000] *** b
        [00000000] *** c
        sleep(2200ms);
        [00000500] *** c
        [00001000] *** a
        [00001000] *** b
        [00001000] *** c
        [00001500] *** c
        [00002000] *** a
        [00002000] *** b
        [00002000] *** c
        """);
  }

  @Test
  void frozenSleepersKeepTheirRank() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        { sleep(2s); echo("a") }, t: { sleep(1s); echo("b") }, { sleep(2s); echo("c") },
        t.freeze;
        sleep(1s);
        t.unfreeze;
        sleep(3s);
        [00002000] *** a
        [00002000] *** b
        [00002000] *** c
        """);
  }

  @Test
  void jobsRunInTheOrderInWhichTheyBegan() {
    ConsoleTranscript.check(
        """
        for (var i : 5) { echo(i), };
        [00000000] *** 0
        [00000000] *** 1
        [00000000] *** 2
        [00000000] *** 3
        [00000000] *** 4
        for& (var i : 3) { echo("a%s" % i); echo("b%s" % i) };
        [00000000] *** a0
        [00000000] *** a1
        [00000000] *** a2
        [00000000] *** b0
        [00000000] *** b1
        [00000000] *** b2
        { echo(1) & echo(2) & echo(3) };
        [00000000] *** 1
        [00000000] *** 2
        [00000000] *** 3
        { echo(1), echo(2), echo(3) };
        [00000000] *** 1
        [00000000] *** 2
        [00000000] *** 3
        """);
  }
}
