package org.urbi.kernel.event;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;

/** What is done when an event is emitted (manual, "Event handlers"). */
class AtEventTest {
  @Test
  void eachEmissionIsHandled() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at (e?) echo("one");
        at (e?) echo("two");
        e!;
        [00000000] *** one
        [00000000] *** two
        e!;
        [00000000] *** one
        [00000000] *** two
        """);
  }

  @Test
  void thePayloadIsMatchedAndBound() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at (e?(var x)) echo("one: " + x);
        at (e?(var x, var y)) echo("two: " + x + y);
        at (e?(1, var y)) echo("begins with 1: " + y);
        at (e?()) echo("empty");
        at (e?) echo("any");
        e!;
        [00000000] *** empty
        [00000000] *** any
        e!(1);
        [00000000] *** one: 1
        [00000000] *** any
        e!(1, 2);
        [00000000] *** two: 12
        [00000000] *** begins with 1: 2
        [00000000] *** any
        e!(2, 3);
        [00000000] *** two: 23
        [00000000] *** any
        """);
  }

  @Test
  void aGuardHasItsSay() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at (e?(var x) if 2 < x) echo("more: " + x) onleave echo("no more: " + x);
        at (e? if false) echo("never");
        e!(2);
        e!(3);
        [00000000] *** more: 3
        [00000000] *** no more: 3
        e!("x" == "y", 1);
        """);
  }

  @Test
  void handlersEnterAndLeaveInTheirOrder() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at (e?) echo("enter 1") onleave echo("leave 1");
        at (e?) echo("enter 2") onleave echo("leave 2");
        e!;
        [00000000] *** enter 1
        [00000000] *** leave 1
        [00000000] *** enter 2
        [00000000] *** leave 2
        sleep(1ms);
        at sync (e?) echo("enter 3") onleave echo("leave 3");
        e!;
        [00000001] *** enter 3
        [00000001] *** leave 3
        [00000001] *** enter 1
        [00000001] *** leave 1
        [00000001] *** enter 2
        [00000001] *** leave 2
        """);
  }

  @Test
  void anEmissionMayLast() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at (e?(var x)) echo("enter " + x) onleave echo("leave " + x);
        e!(1) ~ 2s, sleep(1s);
        [00000000] *** enter 1
        e!(2) ~ 2s, sleep(4s);
        [00001000] *** enter 2
        [00002000] *** leave 1
        [00003000] *** leave 2
        { e!(3) ~ 1s; echo("over") };
        [00005000] *** enter 3
        [00006000] *** leave 3
        [00006000] *** over
        """);
  }

  @Test
  void whoComesLateHearsOfWhatLasts() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        { e!(7) ~ 2s; echo("over") },
        sleep(1s);
        at (e?(var x)) echo("enter " + x) onleave echo("leave " + x);
        [00001000] *** enter 7
        sleep(2s);
        [00002000] *** leave 7
        [00002000] *** over
        at (e?(var x)) echo("never");
        """);
  }

  @Test
  void anEmissionMustLastLongEnough() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at (e? ~ 1s) echo("enter") onleave echo("leave");
        e!;
        e! ~ 500ms, sleep(2s);
        e! ~ 3s, sleep(5s);
        [00003000] *** enter
        [00005000] *** leave
        echo("end");
        [00007000] *** end
        """);
  }

  @Test
  void twoEmissionsThatLastAreTwo() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at (e?(var x) ~ 1s) echo("enter " + x) onleave echo("leave " + x);
        e!(1) ~ 3s, sleep(500ms);
        e!(2) ~ 3s, sleep(5s);
        [00001000] *** enter 1
        [00001500] *** enter 2
        [00003000] *** leave 1
        [00003500] *** leave 2
        """);
  }

  @Test
  void theBodyOfAnEventIsRunByJobsOfItsOwn() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at (e?(var x)) { sleep(1s); echo("done " + x) };
        e!(1); e!(2); echo("emitted");
        [00000000] *** emitted
        sleep(2s);
        [00001000] *** done 1
        [00001000] *** done 2
        at sync (e?(3)) { sleep(1s); echo("sync done") };
        { e!(3); echo("emitted") };
        [00003000] *** sync done
        [00003000] *** done 3
        [00003000] *** emitted
        sleep(2s);
        e.syncEmit(4); echo("waited");
        [00006000] *** done 4
        [00006000] *** waited
        sleep(2s);
        """);
  }

  @Test
  void aStoppedHandlerIsGone() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var e = Event.new|;
        t: at (e?) echo("never");
        e.hasSubscribers;
        [00000000] true
        t.stop;
        e.hasSubscribers;
        [00000000] false
        e!;
        """);
  }

  @Test
  void aFrozenHandlerIsDeaf() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var e = Event.new|;
        t: at (e?) echo("heard");
        t.freeze;
        e!;
        sleep(1s);
        t.unfreeze;
        sleep(1s);
        e!;
        [00002000] *** heard
        """);
  }

  @Test
  void aHandlerThatFailsKeepsNobodyFromHearing() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at (e?) throw Exception.new("first");
        at (e?) echo("second");
        { e!; echo("emitted") };
        [00000000:error] !!! 2.9-36: first
        [00000000] *** second
        [00000000] *** emitted
        sleep(1s);
        """);
  }

  @Test
  void variablesOfActivationsAreTheirOwn() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        for (var i : [1, 2]) at (e?(var x)) { var mine = x * i; sleep(1s); echo("%s %s %s" % [i, x, mine]) };
        e!(10); sleep(500ms); e!(20);
        sleep(2s);
        [00001000] *** 1 10 10
        [00001000] *** 2 10 20
        [00001500] *** 1 20 20
        [00001500] *** 2 20 40
        """);
  }

  @Test
  void whatIsNoEventMayBeSeenAsOne() {
    ConsoleTranscript.check(
        """
        class Bell { var event = Event.new; function asEvent() { event } }|;
        var bell = Bell.new|;
        at (bell?) echo("rings");
        bell.event!;
        [00000000] *** rings
        at (1?) echo("never");
        [00000000:error] !!! 5.5: ?: this: unexpected 1, expected an Event
        at (nil?(1)) echo("never");
        [00000000:error] !!! 6.5-7: ?: this: unexpected nil, expected an Event
        class Odd { function asEvent() { 3 } }|;
        var odd = Odd.new|;
        at (odd?) echo("never");
        [00000000:error] !!! 9.5-7: ?: this: unexpected Odd_0x7f000010, expected an Event
        """);
  }

  @Test
  void whatLooksLikeAnEventHasAnEmitOfItsOwn() {
    ConsoleTranscript.check(
        """
        class Loud { function emit(args[]) { echo("emit " + args) } }|;
        var loud = Loud.new|;
        loud!(1, 2);
        [00000000] *** emit [1, 2]
        loud!;
        [00000000] *** emit []
        1!;
        [00000000:error] !!! 5.1-2: lookup failed: emit (possible misspelling of min)
        """);
  }

  @Test
  void aDurationIsANumber() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        e! ~ "long";
        [00000000:error] !!! 2.6-11: duration: argument 1: unexpected "long", expected a Float
        at (e? ~ "long") echo("never");
        [00000000:error] !!! 3.10-15: duration: argument 1: unexpected "long", expected a Float
        e! ~ 0s;
        e! ~ (-1s);
        echo("on");
        [00000000] *** on
        """);
  }

  @Test
  void whoBeginsToListenIsTold() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        var e.onSubscribe = Event.new|;
        at (e.onSubscribe?) echo("somebody listens");
        at (e?) echo("heard");
        [00000000] *** somebody listens
        e!;
        [00000000] *** heard
        """);
  }

  @Test
  void aHandlerAddedWhileOthersAreToldWaitsForTheNext() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at sync (e?) { at (e?) echo("inner") };
        e!;
        sleep(1ms);
        e!;
        [00000001] *** inner
        sleep(1ms);
        """);
  }

  @Test
  void aHandlerStoppedWhileOthersAreToldIsNotTold() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var e = Event.new|;
        at sync (e?) { t.stop; echo("stopped it") };
        t: at (e?) echo("never");
        e!;
        [00000000] *** stopped it
        sleep(1s);
        """);
  }

  @Test
  void anEmissionEndsForThoseWhoListenStill() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var e = Event.new|;
        t: at (e?) echo("enter") onleave echo("leave");
        at (e?) echo("enter 2") onleave echo("leave 2");
        e! ~ 2s,
        [00000000] *** enter
        [00000000] *** enter 2
        sleep(1s);
        t.stop;
        sleep(2s);
        [00002000] *** leave 2
        """);
  }

  @Test
  void whatWasToBeDoneLaterIsNotWhenItIsStopped() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var e = Event.new|;
        t: at (e? ~ 1s) echo("never") onleave echo("never");
        e! ~ 3s,
        sleep(500ms);
        t.stop;
        sleep(4s);
        """);
  }

  @Test
  void aTriggeredEventLastsUntilItIsEnded() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at (e?(var x)) echo("enter " + x) onleave echo("leave " + x);
        var h = e.trigger(5)|;
        [00000000] *** enter 5
        sleep(1s);
        h.stop;
        [00001000] *** leave 5
        sleep(1s);
        h.stop;
        sleep(1s);
        """);
  }

  @Test
  void anEmissionThatIsStoppedIsOver() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var e = Event.new|;
        at (e?) echo("enter") onleave echo("leave");
        t: e! ~ 5s,
        [00000000] *** enter
        sleep(1s);
        t.stop;
        [00001000] *** leave
        sleep(1s);
        """);
  }

  @Test
  void anEmissionThatLastsReachesWhoListensLater() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        var h = e.trigger(5)|;
        sleep(1s);
        at (e?(var x)) echo("in " + x) onleave echo("out " + x);
        [00001000] *** in 5
        sleep(1s);
        h.stop;
        [00002000] *** out 5
        sleep(1s);
        """);
  }

  @Test
  void aHandlerThatTheOneBeforeStopsIsNotCalled() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var e = Event.new|;
        at sync (e?) t.stop;
        t: at sync (e?) echo("stopped");
        at sync (e?) echo("not stopped");
        var h = e.trigger|;
        [00000000] *** not stopped
        h.stop;
        """);
  }

  @Test
  void callsThatHaveEndedAreNotNested() {
    ConsoleTranscript.check(
        """
        var n = 0|;
        var e = Event.new|;
        at sync (e?) n++;
        for| (20000) e!;
        n;
        [00000000] 20000
        """);
  }
}
