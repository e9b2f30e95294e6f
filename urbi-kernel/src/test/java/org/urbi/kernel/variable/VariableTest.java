package org.urbi.kernel.variable;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;

/** Variables with hooks behind slots of objects (manual, "UVar"). */
class VariableTest {
  @Test
  void itTakesOverTheValueOfItsSlot() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var o.x = 5|;
        var v = UVar.new(o, "x")|;
        o.x;
        [00000000] 5
        v.val; v.valsensor; v.owned;
        [00000000] 5
        [00000000] 5
        [00000000] false
        o.x = 6;
        [00000000] 6
        o.x; v.val;
        [00000000] 6
        [00000000] 6
        v.val = 7;
        [00000000] 7
        o.x;
        [00000000] 7
        var w = UVar.new(o, "fresh")|;
        o.fresh.isVoid;
        [00000000] true
        o.fresh = 1;
        [00000000] 1
        o.fresh;
        [00000000] 1
        """);
  }

  @Test
  void aCommandToAnOwnedOneCountsAsWriting() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var o.x = 5|;
        var v = UVar.new(o, "x")|;
        v.owned = true|;
        sleep(2s);
        o.x = 6|;
        v.timestamp == System.time;
        [00002000] true
        """);
  }

  @Test
  void changesAreTold() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var o.x = 5|;
        var v = UVar.new(o, "x")|;
        var a = v.notifyChange(function () { echo("a: " + val) })|;
        var b = v.notifyChange(closure () { echo("b: " + o.x) })|;
        o.x = 6|;
        [00000000] *** a: 6
        [00000000] *** b: 6
        v.val = 6|;
        [00000000] *** a: 6
        [00000000] *** b: 6
        v.removeNotifyChange(a);
        [00000000] true
        v.removeNotifyChange(a);
        [00000000] false
        o.x = 7|;
        [00000000] *** b: 7
        v.removeNotifyChangeOwned(b);
        [00000000] false
        v.removeNotifyAccess(b);
        [00000000] false
        v.removeNotifyChange(b);
        [00000000] true
        o.x = 8|;
        """);
  }

  @Test
  void readersAreTold() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var o.x = 5|;
        var v = UVar.new(o, "x")|;
        var a = v.notifyAccess(function () { echo("read"); valsensor = valsensor + 1 })|;
        o.x;
        [00000000] *** read
        [00000000] 6
        o.x;
        [00000000] *** read
        [00000000] 7
        v.val;
        [00000000] 7
        v.removeNotifyAccess(a);
        [00000000] true
        o.x;
        [00000000] 7
        """);
  }

  @Test
  void anOwnedOneHasATargetAndASensedValue() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var o.x = 5|;
        var v = UVar.new(o, "x")|;
        v.owned = true;
        [00000000] true
        v.owned;
        [00000000] true
        v.notifyChangeOwned(function () { echo("target " + val) })|;
        v.notifyChange(function () { echo("sensed " + valsensor) })|;
        at (o.x == 7) echo("seven");
        o.x = 6;
        [00000000] *** target 6
        [00000000] 6
        o.x; v.val; v.valsensor;
        [00000000] 5
        [00000000] 6
        [00000000] 5
        v.valsensor = 7;
        [00000000] *** sensed 7
        [00000000] 7
        [00000000] *** seven
        o.x; v.val;
        [00000000] 7
        [00000000] 6
        sleep(1ms);
        v.owned = false;
        [00000001] false
        v.owned;
        [00000001] true
        """);
  }

  @Test
  void whatIsNotOwnedTellsBothKindsOfHooks() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var v = UVar.new(o, "x")|;
        v.notifyChange(function () { echo("change") })|;
        v.notifyChangeOwned(function () { echo("owned") })|;
        v.owned;
        [00000000] false
        o.x = 1|;
        [00000000] *** change
        [00000000] *** owned
        v.valsensor = 2|;
        [00000000] *** change
        [00000000] *** owned
        o.x;
        [00000000] 2
        """);
  }

  @Test
  void theRangeIsKept() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var o.x = 5|;
        var v = UVar.new(o, "x")|;
        o.x->rangemin = 0|;
        o.x->rangemax = 10|;
        o.x = 11|; o.x;
        [00000000] 10
        o.x = -1|; o.x;
        [00000000] 0
        o.x = 10|; o.x;
        [00000000] 10
        o.x = 0|; o.x;
        [00000000] 0
        o.x = 3.5|; o.x;
        [00000000] 3.5
        o.x = nan|; o.x;
        [00000000] nan
        o.x = "far"|; o.x;
        [00000000] "far"
        v.owned = true|;
        o.x = 12|; v.val; o.x;
        [00000000] 10
        [00000000] "far"
        v.valsensor = -5|; o.x;
        [00000000] 0
        o.x->rangemax = "high"|;
        o.x = 100|; v.val;
        [00000000] 100
        """);
  }

  @Test
  void aHookThatWritesIsNotCalledForIt() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var o.x = 0|;
        var v = UVar.new(o, "x")|;
        v.notifyChange(function () { echo("seen " + val); val = val * 2 })|;
        o.x = 1|;
        [00000000] *** seen 1
        o.x;
        [00000000] 2
        o.x = 5|;
        [00000000] *** seen 5
        o.x;
        [00000000] 10
        """);
  }

  @Test
  void otherJobsAreToldMeanwhile() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var o.x = 0|;
        var v = UVar.new(o, "x")|;
        v.notifyChange(function () { echo("in " + val); sleep(1s); echo("out") })|;
        { o.x = 1; echo("set 1") },
        [00000000] *** in 1
        sleep(500ms);
        { o.x = 2; echo("set 2") },
        [00000500] *** in 2
        sleep(3s);
        [00001000] *** out
        [00001000] *** set 1
        [00001500] *** out
        [00001500] *** set 2
        """);
  }

  @Test
  void aHookThatFailsKeepsNoOtherFromRunning() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var o.x = 0|;
        var v = UVar.new(o, "x")|;
        v.notifyChange(function () { 1 / 0 })|;
        v.notifyChange(function () { echo("second") })|;
        o.x = 1|;
        [00000000:error] !!! Exception caught while processing notify on Object_0x7f000010.x:
        [00000000:error] !!! 4.30-34: /: division by 0
        [00000000] *** second
        o.x = 2|;
        [00000000:error] !!! Exception caught while processing notify on Object_0x7f000010.x:
        [00000000:error] !!! 4.30-34: /: division by 0
        [00000000] *** second
        UVar.eraseThrowingCallbacks;
        [00000000] false
        UVar.eraseThrowingCallbacks = true|;
        o.x = 3|;
        [00000000:error] !!! Exception caught while processing notify on Object_0x7f000010.x:
        [00000000:error] !!! 4.30-34: /: division by 0
        [00000000] *** second
        o.x = 4|;
        [00000000] *** second
        """);
  }

  @Test
  void hooksMayGoAndComeWhileTheyRun() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var o.x = 0|;
        var v = UVar.new(o, "x")|;
        var ids = []|;
        v.notifyChange(closure () { v.removeNotifyChange(ids[0]); v.notifyChange(function () { echo("new") })|; echo("first") })|;
        ids << v.notifyChange(function () { echo("never") })|;
        o.x = 1|;
        [00000000] *** first
        o.x = 2|;
        [00000000] *** first
        [00000000] *** new
        """);
  }

  @Test
  void itMayStandBehindSeveralSlots() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var p = Object.new|;
        var o.x = 5|;
        var v = UVar.new(o, "x")|;
        v.copy(p, "y");
        p.y;
        [00000000] 5
        p.y = 6;
        [00000000] 6
        o.x;
        [00000000] 6
        at (o.x == 8) echo("o");
        at (p.y == 8) echo("p");
        o.x = 8|;
        [00000000] *** o
        [00000000] *** p
        sleep(1ms);
        p.removeLocalSlot("y")|;
        [00000001:error] !!! 10.5-7: lookup failed: y
        [00000001:error] !!! 10.5-7: lookup failed: y
        o.x = 9|;
        o.x;
        [00000001] 9
        """);
  }

  @Test
  void conditionsSeeIt() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var o.x = 0|;
        var v = UVar.new(o, "x")|;
        at (o.x > 3) echo("high") onleave echo("low");
        o.x = 4|;
        [00000000] *** high
        sleep(1ms);
        v.val = 2|;
        [00000001] *** low
        sleep(1ms);
        at (o.x->changed?) echo("changed");
        at (v.changed?(var n)) echo("now " + n);
        o.x = 5|;
        [00000002] *** changed
        [00000002] *** now 5
        [00000002] *** high
        sleep(1ms);
        """);
  }

  @Test
  void whatIsSetWhenItIsReadIsReadForThoseWhoWatch() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var o.t = 0|;
        var v = UVar.new(o, "t")|;
        var count = 0|;
        var a = v.notifyAccess(closure () { count++; v.valsensor = count })|;
        at (o.t > 5) echo("five");
        sleep(200ms);
        [00000100] *** five
        v.removeNotifyAccess(a);
        [00000200] true
        var n = count|;
        sleep(1s);
        count == n;
        [00001200] true
        """);
  }

  @Test
  void thePeriodOfTheSystemIsThatOfTheReading() {
    ConsoleTranscript.check(
        """
        System.period = 100ms|;
        var o = Object.new|;
        var o.t = 0|;
        var v = UVar.new(o, "t")|;
        var count = 0|;
        v.notifyAccess(closure () { count++; v.valsensor = count; echo("read") })|;
        sleep(300ms);
        var id = v.notifyChange(function () { echo("told " + val) })|;
        sleep(250ms);
        [00000400] *** told 1
        [00000400] *** read
        [00000500] *** told 2
        [00000500] *** read
        v.removeNotifyChange(id);
        [00000550] true
        sleep(500ms);
        """);
  }

  @Test
  void whoReadsSlowlyIsNotReadTwice() {
    ConsoleTranscript.check(
        """
        System.period = 100ms|;
        var o = Object.new|;
        var o.t = 0|;
        var v = UVar.new(o, "t")|;
        v.notifyAccess(function () { echo("begin"); sleep(250ms); echo("end") })|;
        v.notifyChange(function () { echo("told") })|;
        sleep(450ms);
        [00000100] *** begin
        [00000350] *** end
        [00000400] *** begin
        """);
  }

  @Test
  void connectionsLeadValues() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var o.x = 1|; var o.y = 2|; var o.z = 3|;
        var x = UVar.new(o, "x")|; var y = UVar.new(o, "y")|; var z = UVar.new(o, "z")|;
        var c = x >> y|;
        z << x|;
        x.changeConnections.size;
        [00000000] 2
        x.changeConnections[0] === c;
        [00000000] true
        o.y;
        [00000000] 2
        o.x = 5|;
        [o.y, o.z];
        [00000000] [5, 5]
        c.enabled = false|;
        o.x = 6|;
        [o.y, o.z];
        [00000000] [5, 6]
        c.enabled = true|;
        o.x = 7|;
        [o.y, o.z];
        [00000000] [7, 7]
        c.disconnect;
        c.disconnect;
        x.changeConnections.size;
        [00000000] 1
        o.x = 8|;
        [o.y, o.z];
        [00000000] [7, 8]
        c.callCount;
        [00000000] 2
        """);
  }

  @Test
  void connectionsMayBeSlowAndAsynchronous() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var o.x = 1|; var o.y = 2|;
        var x = UVar.new(o, "x")|; var y = UVar.new(o, "y")|;
        var c = x >> y|;
        c.minInterval = 1s|;
        o.x = 2|; o.x = 3|; o.y;
        [00000000] 2
        sleep(1s);
        o.x = 4|; o.y;
        [00001000] 4
        c.minInterval = 0|;
        c.asynchronous = true|;
        y.notifyChange(function () { sleep(1s); echo("told " + val) })|;
        { o.x = 5; echo("set") };
        [00001000] *** set
        sleep(100ms);
        o.y;
        [00001100] 5
        { o.x = 6; echo("set, dropped") };
        [00001100] *** set, dropped
        sleep(2s);
        [00002000] *** told 5
        o.y;
        [00003100] 5
        """);
  }

  @Test
  void aConnectionWritesTheTargetOfAnOwnedOne() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var o.x = 1|; var o.y = 2|;
        var x = UVar.new(o, "x")|; var y = UVar.new(o, "y")|;
        x >> y|; y.owned = true|;
        o.x = 3|;
        [y.val, y.valsensor];
        [00000000] [3, 2]
        """);
  }

  @Test
  void clonesAreVariablesOfTheirOwn() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var v = UVar.new(o, "x")|;
        o.x = 5|;
        var w = v.clone|;
        w.val.isVoid;
        [00000000] true
        w.val = 6|;
        o.x; w.val;
        [00000000] 5
        [00000000] 6
        """);
  }

  @Test
  void theSwitchOfDatagramsIsThatOfThePrototype() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var v = UVar.new(o, "x")|;
        v.rtp;
        UVar.rtp = true|;
        v.rtp;
        [00000000] true
        v.rtp = false|;
        v.rtp; UVar.rtp;
        [00000000] false
        [00000000] true
        v.rtp = nil|;
        v.rtp;
        [00000000] true
        UVar.rtp = nil|;
        v.rtp;
        """);
  }
}
