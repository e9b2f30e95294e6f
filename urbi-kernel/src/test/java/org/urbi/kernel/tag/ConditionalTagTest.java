package org.urbi.kernel.tag;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;

/** Code that time or a condition stops or freezes (manual, "Control flow"). */
class ConditionalTagTest {
  @Test
  void timeoutStopsWhatTakesLonger() {
    ConsoleTranscript.check(
        """
        timeout(2s) { echo("in"); sleep(5s); echo("never") };
        [00000000] *** in
        echo("after");
        [00002000] *** after
        timeout(3s) { sleep(1s); echo("done") };
        [00003000] *** done
        echo("done after");
        [00003000] *** done after
        sleep(5s);
        echo("still here");
        [00008000] *** still here
        """);
  }

  @Test
  void timeoutsOfOthersDoNotCount() {
    ConsoleTranscript.check(
        """
        timeout(5s) { timeout(1s) sleep(3s); echo("inner over"); sleep(1s); echo("in time") };
        [00001000] *** inner over
        [00002000] *** in time
        timeout(1s) { timeout(5s) sleep(3s); echo("never") };
        echo("over");
        [00003000] *** over
        """);
  }

  @Test
  void aTimeoutNeedsATime() {
    ConsoleTranscript.check(
        """
        timeout("x") echo(1);
        [00000000:error] !!! 1.9-11: timeout: argument 1: unexpected "x", expected a Float
        timeout(nil) echo(1);
        [00000000:error] !!! 2.9-11: timeout: argument 1: unexpected nil, expected a Float
        { timeout(-1s) { echo("now"); sleep(1s); echo("never") } };
        [00000000] *** now
        { timeout(inf) { sleep(1s); echo("long") } };
        [00001000] *** long
        """);
  }

  @Test
  void timeoutsStopAtTheSameTimeAsSleepsInTheirOrder() {
    ConsoleTranscript.check(
        """
        { timeout(1s) { sleep(2s) }; echo("timeout") }, { sleep(1s); echo("sleep") },
        sleep(2s);
        [00001000] *** timeout
        [00001000] *** sleep
        { sleep(1s); echo("sleep") }, { timeout(1s) { sleep(2s) }; echo("timeout") },
        sleep(2s);
        [00003000] *** sleep
        [00003000] *** timeout
        """);
  }

  @Test
  void stopifStopsWhenTheConditionHolds() {
    ConsoleTranscript.check(
        """
        var b = false|;
        stopif (b) { echo("in"); sleep(3s); echo("never") },
        [00000000] *** in
        sleep(1s); b = true; echo("set"); sleep(3s);
        [00001000] true
        [00001000] *** set
        """);
  }

  @Test
  void stopifEndsWithItsCode() {
    ConsoleTranscript.check(
        """
        var b = false|;
        { stopif (b) { sleep(1s); echo("over") }; echo("next"); sleep(2s); echo("going on") },
        sleep(1500ms);
        [00001000] *** over
        [00001000] *** next
        b = true;
        [00001500] true
        sleep(2s);
        [00003000] *** going on
        """);
  }

  @Test
  void stopifWithAConditionThatHoldsEndsAfterTheFirstStep() {
    ConsoleTranscript.check(
        """
        stopif (true) { echo("in"); sleep(1s); echo("never") };
        [00000000] *** in
        echo("after");
        [00000000] *** after
        """);
  }

  @Test
  void stopifOnAnEvent() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        stopif (e?) { echo("in"); sleep(3s); echo("never") },
        [00000000] *** in
        sleep(1s);
        e!;
        sleep(3s);
        """);
  }

  @Test
  void freezeifSuspendsAsLongAsTheConditionHolds() {
    ConsoleTranscript.check(
        """
        var b = false|;
        freezeif (b) { every|(1s) { echo("tick") } },
        [00000000] *** tick
        sleep(1500ms);
        [00001000] *** tick
        b = true;
        [00001500] true
        sleep(3s);
        b = false;
        [00004500] false
        sleep(2s);
        [00005000] *** tick
        [00006000] *** tick
        b = true;
        [00006500] true
        sleep(3s);
        """);
  }

  @Test
  void freezeifEndsWithItsCode() {
    ConsoleTranscript.check(
        """
        var b = false|;
        { freezeif (b) { echo("in") }; sleep(1s); echo("going on") },
        [00000000] *** in
        sleep(500ms);
        b = true;
        [00000500] true
        sleep(1s);
        [00001000] *** going on
        """);
  }

  @Test
  void scopeTagsAreStoppedWhenTheScopeIsLeft() {
    ConsoleTranscript.check(
        """
        { scopeTag: { sleep(1s); echo("never") }, echo("leaving") };
        [00000000] *** leaving
        sleep(2s);
        function f() { scopeTag: { sleep(1s); echo("never") }, return 3 }|;
        f;
        [00002000] 3
        try { scopeTag: { sleep(1s); echo("never") }, throw "out" } catch (var e) { echo(e) };
        [00002000] *** out
        sleep(2s);
        """);
  }

  @Test
  void everyScopeHasATagOfItsOwn() {
    ConsoleTranscript.check(
        """
        { scopeTag: { sleep(1s); echo("outer goes on") }, { scopeTag: { sleep(1s); echo("never") }, echo("inner") }; sleep(2s); };
        [00000000] *** inner
        [00001000] *** outer goes on
        """);
  }

  @Test
  void unknownTagsAreMadeAndKept() {
    ConsoleTranscript.check(
        """
        foo: echo(1);
        [00000000] *** 1
        foo;
        [00000000] Tag<foo>
        Tag.tags.foo === foo;
        [00000000] true
        foo: { sleep(1s); echo("never") },
        sleep(500ms);
        foo.stop;
        sleep(1s);
        """);
  }

  @Test
  void whatIsKnownIsNotMade() {
    ConsoleTranscript.check(
        """
        { var baz = Tag.new("mine"); baz: { echo("in") }; baz };
        [00000000] *** in
        [00000000] Tag<mine>
        baz;
        [00000000:error] !!! 2.1-3: lookup failed: baz (possible misspelling of tan)
        var o = Object.new|;
        o.bar: echo(2);
        [00000000:error] !!! 4.1-5: lookup failed: bar (possible misspelling of warn)
        bar;
        [00000000:error] !!! 5.1-3: lookup failed: bar (possible misspelling of warn)
        class C { var mine = Tag.new("slot"); function f() { mine: { sleep(1s); echo("never") } } }|;
        var c = C.new|;
        c.f,
        sleep(500ms);
        c.mine.stop;
        c.mine;
        [00000500] Tag<slot>
        mine;
        [00000500:error] !!! 12.1-4: lookup failed: mine (possible misspelling of min)
        """);
  }

  @Test
  void codeHasNoValueUnlessItIsLeft() {
    ConsoleTranscript.check(
        """
        { timeout(1s) 42 };
        { stopif(false) 43 };
        { freezeif(false) 44 };
        function left() { timeout(1s) { return 45 }; 46 }|;
        left;
        [00000000] 45
        """);
  }

  @Test
  void theWatchdogGoesWithTheCode() {
    ConsoleTranscript.check(
        """
        var e = Event.new|;
        { stopif(e?) { sleep(1s) }; echo("over") },
        e.hasSubscribers;
        [00000000] true
        sleep(2s);
        [00001000] *** over
        e.hasSubscribers;
        [00002000] false
        { freezeif(e?) { sleep(1s) }; echo("over") },
        e.hasSubscribers;
        [00002000] true
        sleep(2s);
        [00003000] *** over
        e.hasSubscribers;
        [00004000] false
        """);
  }
}
