package org.urbi.kernel.event;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;

/** Who listens to an event, on terms of his own (manual, "Customizing data-flow links"). */
class SubscriptionTest {
  @Test
  void theyAreSwitchedOffAndOn() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at (e?(var x)) echo("one " + x);
        at (e?(var x)) echo("two " + x);
        e.subscribers.size;
        [00000000] 2
        var s = e.subscribers[0]|;
        s === e.subscribers[0];
        [00000000] true
        s.enabled;
        [00000000] true
        e!(1);
        [00000000] *** one 1
        [00000000] *** two 1
        sleep(1ms);
        s.enabled = false|;
        e!(2);
        [00000001] *** two 2
        sleep(1ms);
        s.enabled = true|;
        e!(3);
        [00000002] *** one 3
        [00000002] *** two 3
        sleep(1ms);
        s.disconnect;
        e.subscribers.size;
        [00000003] 1
        e!(4);
        [00000003] *** two 4
        sleep(1ms);
        """);
  }

  @Test
  void thereIsALeastTimeBetweenTwoCalls() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at (e?(var x)) echo(x);
        var s = e.subscribers[0]|;
        s.minInterval;
        [00000000] 0
        s.minInterval = 1s|;
        e!(1);
        [00000000] *** 1
        e!(2);
        sleep(500ms);
        e!(3);
        sleep(500ms);
        e!(4);
        [00001000] *** 4
        sleep(1001ms);
        e!(5);
        [00002001] *** 5
        sleep(1ms);
        s.minInterval;
        [00002002] 1
        s.callCount;
        [00002002] 3
        s.fireRate;
        [00002002] 0.9995
        """);
  }

  @Test
  void anAsynchronousOneIsCalledByAJobAndDropsWhatComesMeanwhile() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at sync (e?(var x)) { echo("in " + x); sleep(1s); echo("out " + x) };
        var s = e.subscribers[0]|;
        s.asynchronous;
        [00000000] false
        s.asynchronous = true|;
        s.asynchronous;
        [00000000] true
        e!(1); echo("emitted");
        [00000000] *** in 1
        [00000000] *** emitted
        sleep(500ms);
        e!(2); echo("dropped");
        [00000500] *** dropped
        sleep(1s);
        [00001000] *** out 1
        e!(3);
        [00001500] *** in 3
        sleep(2s);
        [00002500] *** out 3
        s.callCount;
        [00003500] 2
        """);
  }

  @Test
  void callsAreCountedAndTimed() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at sync (e?(var x)) { sleep(x) };
        var s = e.subscribers[0]|;
        s.callCount; s.meanCallTime; s.minCallTime; s.maxCallTime; s.fireRate;
        [00000000] 0
        [00000000] 0
        [00000000] 0
        [00000000] 0
        [00000000] 0
        e!(1s);
        s.callCount; s.meanCallTime; s.minCallTime; s.maxCallTime; s.fireRate;
        [00001000] 1
        [00001000] 1
        [00001000] 1
        [00001000] 1
        [00001000] 0
        e!(3s);
        s.callCount; s.meanCallTime; s.minCallTime; s.maxCallTime; s.fireRate;
        [00004000] 2
        [00004000] 2
        [00004000] 1
        [00004000] 3
        [00004000] 1
        s.resetStats;
        s.callCount; s.meanCallTime; s.minCallTime; s.maxCallTime; s.fireRate;
        [00004000] 0
        [00004000] 0
        [00004000] 0
        [00004000] 0
        [00004000] 0
        """);
  }

  @Test
  void emissionsThatLastAreSubjectToTheTermsToo() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at (e?) echo("in") onleave echo("out");
        var s = e.subscribers[0]|;
        e! ~ 1s;
        [00000000] *** in
        [00001000] *** out
        s.enabled = false|;
        e! ~ 1s;
        sleep(1s);
        """);
  }

  @Test
  void functionsListenWithTheEventAndItsPayload() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        e.onEvent(closure (ev, args) { if (args[0] > 1) args[0] else void }, closure (ev, args, v) { echo("enter %s %s" % [args, v]) }, closure (ev, args, v) { echo("leave %s %s" % [args, v]) });
        [00000000] Subscription_0x7f000010
        e!(1);
        e!(2);
        [00000000] *** enter [2] 2
        [00000000] *** leave [2] 2
        e!(3) ~ 1s;
        [00000000] *** enter [3] 3
        [00001000] *** leave [3] 3
        sleep(1s);
        """);
  }

  @Test
  void functionsThatAreStoppedAreGone() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var e = Event.new|;
        t: e.onEvent(closure (ev, args) { true }, closure (ev, args, v) { echo("enter") }, closure (ev, args, v) { echo("leave") })|;
        e! ~ 2s,
        [00000000] *** enter
        sleep(1s);
        t.stop;
        e.hasSubscribers;
        [00001000] false
        sleep(2s);
        e!;
        """);
  }

  @Test
  void functionsThatAreFrozenAreDeaf() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var e = Event.new|;
        t: e.onEvent(closure (ev, args) { true }, closure (ev, args, v) { echo("heard " + args[0]) })|;
        t.freeze;
        e!(1);
        sleep(1s);
        t.unfreeze;
        e!(2);
        [00001000] *** heard 2
        sleep(1ms);
        """);
  }

  @Test
  void oneThatIsOffSaysSo() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at (e?) echo("heard");
        var s = e.subscribers[0]|;
        s.enabled = false|;
        s.enabled;
        [00000000] false
        """);
  }

  @Test
  void theLeastTimeIsThatSinceTheLastCall() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at (e?(var x)) echo(x);
        var s = e.subscribers[0]|;
        s.minInterval = 1s|;
        sleep(10s);
        e!(1);
        [00010000] *** 1
        sleep(500ms);
        e!(2);
        sleep(600ms);
        e!(3);
        [00011100] *** 3
        sleep(1ms);
        """);
  }

  @Test
  void functionsAreCalledByJobsOfTheirOwnUnlessTheEmissionWaits() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        e.onEvent(closure (ev, args) { true }, closure (ev, args, v) { sleep(1s); echo("heard " + args[0]) }, closure (ev, args, v) {})|;
        e!(1); echo("goes on");
        [00000000] *** goes on
        sleep(2s);
        [00001000] *** heard 1
        e.syncEmit(2); echo("has waited");
        [00003000] *** heard 2
        [00003000] *** has waited
        """);
  }
}
