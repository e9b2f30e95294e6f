package org.urbi.kernel.job;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.urbi.kernel.ConsoleTranscript;

/**
 * Jobs start, wait, are joined and end (manual, "Job", "Parallelism"), the same in both ways to run
 * them.
 */
class JobTest {
  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void aConjunctionWaitsForBoth(JobThreads threads) {
    ConsoleTranscript.check(
        threads,
        """
        { { sleep(2s); echo("slow") } & { sleep(1s); echo("quick") } };
        [00001000] *** quick
        [00002000] *** slow
        echo("both");
        [00002000] *** both
        { sleep(1s); 1 } & { 2 };
        """);
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void theFirstThatFailsEndsTheOthers(JobThreads threads) {
    ConsoleTranscript.check(
        threads,
        """
        { { sleep(1s); missing } & { sleep(2s); echo("never") } };
        [00001000:error] !!! 1.16-22: lookup failed: missing
        echo("on");
        [00001000] *** on
        { { sleep(1s); throw "mine" } & { throw "first" } };
        [00001000:error] !!! first
        sleep(2s);
        function f() { { sleep(1s); return 5 } & { sleep(3s); echo("never") } }|;
        f;
        [00004000] 5
        for| (var i : 3) { { sleep(1s); break } & { sleep(2s); echo("never") } };
        echo("after the loop");
        [00005000] *** after the loop
        """);
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void aScopeWaitsForWhatItStarted(JobThreads threads) {
    ConsoleTranscript.check(
        threads,
        """
        { { sleep(1s); echo("inner") }, echo("end") };
        [00000000] *** end
        [00001000] *** inner
        echo("after");
        [00001000] *** after
        { { sleep(1s); missing }, sleep(3s); echo("never") };
        [00002000:error] !!! 3.16-22: lookup failed: missing
        echo("on");
        [00002000] *** on
        """);
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void detachedJobsGoOn(JobThreads threads) {
    ConsoleTranscript.check(
        threads,
        """
        { detach({ sleep(1s); echo("detached") })|; echo("end") };
        [00000000] *** end
        echo("after");
        [00000000] *** after
        sleep(2s);
        [00001000] *** detached
        var j = detach({ sleep(1s); echo("done") })|;
        j.status;
        [00002000] "sleeping"
        j.waitForTermination;
        [00003000] *** done
        j.status;
        [00003000] "terminated"
        j.timeShift;
        [00003000] 0
        var k = detach({ sleep(5s); echo("never") })|;
        sleep(1ms);
        k.terminate;
        sleep(1ms);
        k.status;
        [00003002] "terminated"
        var d = disown({ sleep(1s); echo("disowned") })|;
        sleep(2s);
        [00004002] *** disowned
        """);
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void frozenJobsHaveATimeOfTheirOwn(JobThreads threads) {
    ConsoleTranscript.check(
        threads,
        """
        var t = Tag.new("t")|;
        var j = detach({ t: { sleep(1s); echo(Job.current.timeShift) } })|;
        sleep(500ms);
        t.freeze;
        sleep(3s);
        t.unfreeze;
        sleep(1s);
        [00004000] *** 3
        """);
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void aFrozenJobThatIsStoppedEnds(JobThreads threads) {
    ConsoleTranscript.check(
        threads,
        """
        var t = Tag.new("t")|;
        var s = Tag.new("s")|;
        { s: { t: { try { sleep(5s) } finally { echo("cleanup") } }; echo("never") }; echo("over") },
        sleep(1s);
        t.freeze;
        sleep(1s);
        s.stop;
        [00002000] *** cleanup
        [00002000] *** over
        sleep(1s);
        t.unfreeze;
        """);
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void theOuterStopWins(JobThreads threads) {
    ConsoleTranscript.check(
        threads,
        """
        var a = Tag.new("a")|;
        var b = Tag.new("b")|;
        { a: { b: { sleep(5s) }; echo("never") }; echo("over") },
        sleep(1s);
        b.stop | a.stop;
        [00001000] *** over
        sleep(1s);
        { a: { b: { sleep(5s) }; echo("never") }; echo("over again") },
        sleep(1s);
        a.stop | b.stop;
        [00003000] *** over again
        sleep(1s);
        """);
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void whoIsStoppedWhileItCleansUpEnds(JobThreads threads) {
    ConsoleTranscript.check(
        threads,
        """
        var t = Tag.new("t")|;
        { t: { try { sleep(5s) } finally { echo("begin"); sleep(1s); echo("end") } }; echo("over") },
        sleep(1s);
        t.stop;
        [00001000] *** begin
        sleep(3s);
        [00002000] *** end
        [00002000] *** over
        """);
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void nonInterruptibleCodeIsAlone(JobThreads threads) {
    ConsoleTranscript.check(
        threads,
        """
        { { nonInterruptible; echo("a1"); echo("a2"); echo("a3") } & { echo("b1"); echo("b2") } };
        [00000000] *** a1
        [00000000] *** a2
        [00000000] *** a3
        [00000000] *** b1
        [00000000] *** b2
        { nonInterruptible; sleep(1s) };
        [00000000:error] !!! 2.21-29: attempt to sleep in non-interruptible code
        { nonInterruptible; { 1 } & { 2 } };
        [00000000:error] !!! 3.21-33: dependency on other task in non-interruptible code
        { sleep(1ms); echo("on") };
        [00000001] *** on
        """);
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void timePassesWhenNobodyCanRun(JobThreads threads) {
    ConsoleTranscript.check(
        threads,
        """
        var t = time|;
        sleep(1000000s);
        time - t;
        [1000000000] 1000000
        sleep(0);
        sleep(-1);
        time - t;
        [1000000000] 1000000
        sleep("x");
        [1000000000:error] !!! 7.1-10: sleep: argument 1: unexpected "x", expected a Float
        { timeout(1s) sleep };
        { timeout(1s) sleep(inf) };
        time - t;
        [1000002000] 1000002
        """);
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void allJobsAreShown(JobThreads threads) {
    ConsoleTranscript.check(
        threads,
        """
        System.ps;
        [00000000] *** Job: shell_2
        [00000000] ***   State: running
        [00000000] ***   Tags:
        [00000000] ***     Tag<Lobby_1>
        [00000000] ***   Backtrace:
        """);
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void aJobThatNeverWaitsLetsTimePass(JobThreads threads) {
    ConsoleTranscript.check(
        threads,
        """
        var n = 0|;
        timeout(5ms) { while (true) { n++ } };
        0 < n;
        [00000005] true
        """);
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void manyJobsAtATime(JobThreads threads) {
    ConsoleTranscript.check(
        threads,
        """
        var n = 0|;
        for& (var i : 1000) { sleep(1s); n++ };
        n;
        [00001000] 1000
        cycle < 100;
        [00001000] true
        """);
  }

  /** Where the stack is small: the end of a large one takes seconds to reach. */
  @Test
  void recursionHasAnEndThatIsCaught() {
    ConsoleTranscript.check(
        JobThreads.BATON,
        """
        function f(n) { f(n + 1) }|;
        try { f(0) } catch (var e) { e.message };
        [00000000] "stack space exhausted"
        echo("on");
        [00000000] *** on
        """);
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void jobsAreListedWithWhatTheyDo(JobThreads threads) {
    ConsoleTranscript.check(
        threads,
        """
        var j = detach({ sleep(1s) })|;
        sleep(1ms);
        j in jobs;
        [00000001] true
        j.status;
        [00000001] "sleeping"
        j.tags.size;
        [00000001] 1
        j.isA(Job);
        [00000001] true
        Job.current.status;
        [00000001] "running"
        sleep(2s);
        j in jobs;
        [00002001] false
        """);
  }
}
