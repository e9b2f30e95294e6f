package org.urbi.kernel.tag;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;

/** Code under tags: who enters, who is let go, and what it returns (manual, "Tag"). */
class TaggedTest {
  @Test
  void codeIsStoppedWithAValueAndNewcomersAreNot() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var res = 0|;
        detach({ res = { t: { echo("in"); sleep(5s); echo("never"); 1 } } })|;
        sleep(1s);
        [00000000] *** in
        t.stop("value");
        sleep(0);
        res;
        [00001000] "value"
        t: 42;
        [00001000] 42
        t.stop;
        res = { t: { sleep(1s); 43 } };
        [00002000] 43
        """);
  }

  @Test
  void codeIsStoppedWithoutAValue() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        var res = 0|;
        { res = { t: sleep(5s) }; echo(res.isVoid) },
        sleep(1s);
        t.stop;
        [00001000:error] !!! 3.3-24: unexpected void
        sleep(1s);
        """);
  }

  @Test
  void blockedCodeReturnsTheValueAndDoesNotBegin() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        { echo({ t: { sleep(5s); echo("never") } }) },
        sleep(1s);
        t.block("blocked");
        [00001000] *** blocked
        t: echo("never");
        [00001000] "blocked"
        t.blocked;
        [00001000] true
        t.unblock;
        t.blocked;
        [00001000] false
        t: echo("again");
        [00001000] *** again
        """);
  }

  @Test
  void theValueOfABlockEndsWithIt() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        t.block("first");
        t: 1;
        [00000000] "first"
        t.unblock;
        t.block;
        t: 2;
        t.unblock;
        t: 3;
        [00000000] 3
        """);
  }

  @Test
  void aTagOfAnotherIsControlledByBoth() {
    ConsoleTranscript.check(
        """
        var outer = Tag.new("outer")|;
        var inner = outer.new("inner")|;
        inner: { echo("one"); sleep(5s); echo("never") },
        [00000000] *** one
        sleep(1s);
        outer.stop;
        inner: { echo("two"); sleep(5s); echo("never") },
        [00001000] *** two
        sleep(1s);
        inner.stop;
        outer: { sleep(1s); echo("outer goes on") },
        sleep(500ms);
        inner.stop;
        sleep(1s);
        outer.block("out");
        inner: echo("never");
        [00003000] *** outer goes on
        [00003500] "out"
        outer: echo("never");
        [00003500] "out"
        outer.unblock;
        inner.block("in");
        outer: echo("outer");
        [00003500] *** outer
        inner: echo("never");
        [00003500] "in"
        """);
  }

  @Test
  void theStopOfTheOuterOneLeavesTheOuterOne() {
    ConsoleTranscript.check(
        """
        var outer = Tag.new("outer")|;
        var inner = outer.new("inner")|;
        { outer: { inner: sleep(5s); echo("inner over"); sleep(5s); echo("never") }; echo("outer over") },
        sleep(1s);
        inner.stop;
        [00001000] *** inner over
        sleep(1s);
        outer.stop;
        [00002000] *** outer over
        sleep(1s);
        """);
  }

  @Test
  void nestedTagsAreLeftFromTheInside() {
    ConsoleTranscript.check(
        """
        var a = Tag.new("a")|;
        var b = Tag.new("b")|;
        { a: { b: { try { sleep(5s) } finally { echo("cleanup") }; echo("never") }; echo("never") }; echo("over") },
        sleep(1s);
        a.stop | b.stop;
        [00001000] *** cleanup
        [00001000] *** over
        sleep(1s);
        """);
  }

  @Test
  void enterAndLeaveAreEmittedOnceEach() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        at (t.enter?) echo("enter");
        at (t.leave?) echo("leave");
        t: echo("in");
        [00000000] *** enter
        [00000000] *** in
        [00000000] *** leave
        t: throw "out";
        [00000000] *** enter
        [00000000] *** leave
        [00000000:error] !!! out
        t: { sleep(5s) },
        [00000000] *** enter
        sleep(1s);
        t.stop;
        [00001000] *** leave
        t.block;
        t: echo("never");
        t.unblock;
        function f() { t: return 3 }|;
        f;
        [00001000] *** enter
        [00001000] *** leave
        [00001000] 3
        """);
  }

  @Test
  void allTagsAroundAreToldFromTheOutside() {
    ConsoleTranscript.check(
        """
        var outer = Tag.new("outer")|;
        var inner = outer.new("inner")|;
        at (outer.enter?) echo("enter outer");
        at (inner.enter?) echo("enter inner");
        at (outer.leave?) echo("leave outer");
        at (inner.leave?) echo("leave inner");
        inner: echo("in");
        [00000000] *** enter outer
        [00000000] *** enter inner
        [00000000] *** in
        [00000000] *** leave inner
        [00000000] *** leave outer
        inner.block;
        inner: echo("never");
        inner.unblock;
        """);
  }

  @Test
  void whoWaitsAtAFrozenTagHasNotEntered() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        at (t.enter?) echo("enter");
        at (t.leave?) echo("leave");
        t.freeze;
        t: echo("in"),
        sleep(1s);
        echo("still frozen");
        [00001000] *** still frozen
        t.unfreeze;
        [00001000] *** enter
        [00001000] *** in
        [00001000] *** leave
        sleep(1s);
        t.freeze;
        t: echo("never"),
        sleep(1s);
        t.stop;
        t.unfreeze;
        sleep(1s);
        """);
  }

  @Test
  void frozenCodeGoesOnWithItsSenseOfTime() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        t: { sleep(2s); echo("awake") },
        sleep(1s);
        t.freeze;
        t.frozen;
        [00001000] true
        sleep(5s);
        t.unfreeze;
        t.frozen;
        [00006000] false
        sleep(2s);
        [00007000] *** awake
        """);
  }

  @Test
  void freezingTwiceIsFreezingOnce() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        t: { sleep(1s); echo("awake") },
        t.freeze; t.freeze;
        sleep(2s);
        t.unfreeze;
        sleep(2s);
        [00003000] *** awake
        t.unfreeze;
        """);
  }

  @Test
  void twoFrozenTagsBothHold() {
    ConsoleTranscript.check(
        """
        var a = Tag.new("a")|;
        var b = Tag.new("b")|;
        a: b: { sleep(1s); echo("awake") },
        a.freeze; b.freeze;
        sleep(2s);
        a.unfreeze;
        sleep(2s);
        b.unfreeze;
        sleep(2s);
        [00005000] *** awake
        """);
  }

  @Test
  void onlyTagsTag() {
    ConsoleTranscript.check(
        """
        1: echo("never");
        [00000000:error] !!! 1.1-16: unexpected 1, expected a Tag
        void: echo("never");
        [00000000:error] !!! 2.1-19: unexpected void
        nil: echo("never");
        [00000000:error] !!! 3.1-18: unexpected nil, expected a Tag
        { var t = "text"; t: echo("never") };
        [00000000:error] !!! 4.19-34: unexpected "text", expected a Tag
        """);
  }

  @Test
  void clonesOfTagAreFreeAndClonesOfTagsAreNot() {
    ConsoleTranscript.check(
        """
        var a = Tag.new|;
        var b = a.new|;
        var c = Tag.clone|;
        a.block(1);
        b: 2;
        [00000000] 1
        c: 3;
        [00000000] 3
        class MyTag : Tag {}|;
        var d = MyTag.new|;
        d: 4;
        [00000000] 4
        """);
  }

  @Test
  void aTagCanStopItself() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        t: { echo("in"); t.stop(5); echo("never") };
        [00000000] *** in
        [00000000] 5
        t: { t.block(6); echo("never") };
        [00000000] 6
        t.unblock;
        t: 7;
        [00000000] 7
        """);
  }

  @Test
  void whatACallOfAFunctionUnderATagReturns() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        function f() { t: { sleep(1s) }; "returned" }|;
        { echo(f) },
        sleep(500ms);
        t.stop;
        [00000500] *** returned
        sleep(1s);
        """);
  }

  @Test
  void codeStartedUnderATagStaysUnderIt() {
    ConsoleTranscript.check(
        """
        var t = Tag.new("t")|;
        t: { detach({ sleep(1s); echo("detached") })|; sleep(1s), echo("in") },
        [00000000] *** in
        sleep(500ms);
        t.stop;
        sleep(2s);
        t: { { sleep(1s); echo("never") }, echo("in") },
        [00002500] *** in
        sleep(500ms);
        t.stop;
        sleep(2s);
        """);
  }

  @Test
  void codeOfAHigherPriorityRunsFirst() {
    ConsoleTranscript.check(
        """
        var high = Tag.new("high")|;
        high.setPriority(10);
        high.priority;
        [00000000] 10
        var low = Tag.new("low")|;
        low.priority;
        [00000000] 0
        low.setPriority(-3);
        low.priority;
        [00000000] 0
        { low: { echo("low 1"); echo("low 2") }, high: { echo("high 1"); echo("high 2") }, };
        [00000000] *** low 1
        [00000000] *** high 1
        [00000000] *** high 2
        [00000000] *** low 2
        sleep(1s);
        { high: low: { echo("both 1"); echo("both 2") }, echo("plain 1"); echo("plain 2"); };
        [00001000] *** both 1
        [00001000] *** both 2
        [00001000] *** plain 1
        [00001000] *** plain 2
        sleep(1s);
        { high: {}; echo("after 1"); echo("after 2"); }, echo("other 1"); echo("other 2");
        [00002000] *** other 1
        [00002000] *** after 1
        [00002000] *** other 2
        [00002000] *** after 2
        """);
  }

  @Test
  void typesOfTagsDoMoreWhereCodeEntersAndLeaves() {
    ConsoleTranscript.check(
        """
        var m = Mutex.new|;
        m: { echo("one in"); sleep(1s); echo("one out") }, m: { echo("two in"); sleep(1s); echo("two out") },
        [00000000] *** one in
        sleep(3s);
        [00001000] *** one out
        [00001000] *** two in
        [00002000] *** two out
        m: throw "out";
        [00003000:error] !!! out
        m: echo("three");
        [00003000] *** three
        """);
  }
}
