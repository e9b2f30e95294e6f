package org.urbi.kernel.library.uobject;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;
import urbi.UObject;
import urbi.UVar;

/** UObjects and their variables, as urbiscript sees them. */
class UObjectsTest {
  /** Adds. */
  public static final class Adder extends UObject {
    private final UVar sum = new UVar();

    public Adder(String name) {
      super(name);
      UBindVar(sum, "sum");
      sum.setValue(0);
      UBindFunction(this, "add");
    }

    /** The sum of all so far. */
    public double add(double summand) {
      sum.setValue(sum.doubleValue() + summand);
      return sum.doubleValue();
    }
  }

  private static void check(String text) {
    ConsoleTranscript.checkWith(List.of(Adder.class), text);
  }

  @Test
  void eachIsFoundByItsName() {
    check(
        """
        uobjects.findUObject("Adder") === Adder;
        [00000000] true
        uobjects.findUObject("Nobody").isNil;
        [00000000] true
        """);
  }

  @Test
  void itEndsWhenItIsDestroyed() {
    check(
        """
        var a = Adder.new|; var name = a.__uobjectName|;
        a.add(2); a.add(3); a.sum;
        [00000000] 2
        [00000000] 5
        [00000000] 5
        a.destroy;
        uobjects.findUObject(name).isNil;
        [00000000] true
        try { UObject.destroy } catch (var e) { echo("no UObject") };
        [00000000] *** no UObject
        """);
  }

  @Test
  void functionsAreMeasuredOnlyWhileThatIsWanted() {
    check(
        """
        Adder.add(1)|; uobjects.getStats.size;
        [00000000] 0
        uobjects.enableStats(true); Adder.add(1)|; Adder.add(1)|;
        for (var p: uobjects.getStats) echo(p.second[3]);
        [00000000] *** 2
        uobjects.clearStats; uobjects.getStats.size;
        [00000000] 0
        uobjects.enableStats(false); Adder.add(1)|; uobjects.getStats.size;
        [00000000] 0
        """);
  }

  @Test
  void aVariableKnowsWhereItStands() {
    check(
        """
        var o = Object.new|; var o.x = 3|;
        var v = UVar.new(o, "x")|;
        v.owner === o;
        [00000000] true
        v.initialName == v.ownerName + ".x";
        [00000000] true
        v.apply([v]); v.val; v.value;
        [00000000] 3
        [00000000] 3
        [00000000] 3
        """);
  }

  @Test
  void whatIsOwnedHasASensedAndACommandedValue() {
    check(
        """
        var o = Object.new|; var o.x = 3|;
        var v = UVar.new(o, "x")|;
        v.owned;
        [00000000] false
        v.owned = true|; v.owned;
        [00000000] true
        v.val = 5|; v.val; v.valsensor;
        [00000000] 5
        [00000000] 3
        v.valsensor = 4|; v.val; v.valsensor; o.x;
        [00000000] 5
        [00000000] 4
        [00000000] 4
        """);
  }

  @Test
  void theWayOfItsValuesIsSet() {
    check(
        """
        var o = Object.new|; var o.x = 3|;
        var v = UVar.new(o, "x")|;
        v.rtp.isNil;
        [00000000] true
        v.rtp = true|; v.rtp; v.rtp = false|; v.rtp; v.rtp = nil|; v.rtp.isNil;
        [00000000] true
        [00000000] false
        [00000000] true
        """);
  }

  @Test
  void whenItWasWrittenIsKnown() {
    check(
        """
        var o = Object.new|; var o.x = 3|;
        var v = UVar.new(o, "x")|;
        sleep(2s); o.x = 4|; v.timestamp == System.time;
        [00002000] true
        sleep(1s); v.timestamp == System.time;
        [00003000] false
        v.update_timed(6, 1); o.x; v.timestamp == System.time;
        [00003000] 6
        [00003000] true
        """);
  }
}
