package org.urbi.kernel.event;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;

/** What must hold for some time counts anew when it has not held; what handlers are worth. */
class HoldingTest {
  @Test
  void atCountsAnew() {
    ConsoleTranscript.check(
        """
        var x = 0|;
        at (x == 1 ~ 1s) echo("held");
        x = 1|;
        sleep(500ms);
        x = 0|;
        sleep(100ms);
        x = 1|;
        sleep(2s);
        [00001600] *** held
        """);
  }

  @Test
  void wheneverCountsAnew() {
    ConsoleTranscript.check(
        """
        var x = 0|;
        whenever (x == 1 ~ 1s) { echo("held"); sleep(10s) },
        x = 1|;
        sleep(500ms);
        x = 0|;
        sleep(100ms);
        x = 1|;
        sleep(2s);
        [00001600] *** held
        """);
  }

  @Test
  void waituntilCountsAnew() {
    ConsoleTranscript.check(
        """
        var x = 0|;
        { waituntil (x == 1 ~ 1s); echo("held") },
        x = 1|;
        sleep(500ms);
        x = 0|;
        sleep(100ms);
        x = 1|;
        sleep(2s);
        [00001600] *** held
        """);
  }

  @Test
  void persistCountsAnew() {
    ConsoleTranscript.check(
        """
        var x = 0|;
        var p = persist(x == 1, 1s)|;
        at (p.val) echo("held");
        x = 1|;
        sleep(500ms);
        x = 0|;
        sleep(100ms);
        x = 1|;
        sleep(2s);
        [00001600] *** held
        """);
  }

  @Test
  void anEventCountsForEachEmission() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        at (e? ~ 1s) echo("at");
        whenever (e? ~ 1s) { echo("whenever"); sleep(10s) },
        { waituntil (e? ~ 1s); echo("waituntil") },
        e! ~ 900ms;
        sleep(50ms);
        e! ~ 1100ms;
        [00001950] *** whenever
        [00001950] *** at
        [00001950] *** waituntil
        sleep(1s);
        """);
  }

  @Test
  void handlersAreWorthNothing() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        var x = 0|;
        { at (e?) {} }.isVoid;
        [00000000] true
        { at (x == 1) {} }.isVoid;
        [00000000] true
        { whenever (e?) {} }.isVoid;
        [00000000] true
        { whenever (x == 1) {} }.isVoid;
        [00000000] true
        { waituntil (x == 0) }.isVoid;
        [00000000] true
        { e! }.isVoid;
        [00000000] true
        { e! ~ 1ms }.isVoid;
        [00000001] true
        class Loud { function emit() { 5 } }|;
        { Loud.new! }.isVoid;
        [00000001] true
        """);
  }

  @Test
  void aWatchThatFailsIsOver() {
    ConsoleTranscript.check(
        """
        var x = 0|;
        watch(1 / 0);
        [00000000:error] !!! 2.7-11: /: division by 0
        watch(x).isA(Event);
        [00000000] true
        """);
  }

  @Test
  void eventsAreSubscribedToOnceMore() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        var f = Event.new|;
        var s = Subscription.new(function (v) { echo("heard " + v) })|;
        e.subscribe(s) === s;
        [00000000] true
        e!(1);
        s.reconnect(f)|;
        [00000000] *** heard 1
        e!(2);
        f!(3);
        [00000000] *** heard 3
        s.disconnect;
        f!(4);
        e.hasSubscribers || f.hasSubscribers;
        [00000000] false
        """);
  }
}
