package org.urbi.kernel.object;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.TreeMap;
import java.util.function.BiConsumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** What a slot has beside its value. */
class SlotDataTest {
  private final UrbiObject root = new World().values().object;
  private final SlotData data = new SlotData();

  @Test
  void propertiesAreListedByName() {
    UrbiObject speed = root.cloned();
    UrbiObject unit = root.cloned();
    data.setProperty("unit", unit);
    data.setProperty("speed", speed);
    assertSame(speed, data.property("speed"));
    assertNull(data.property("other"));
    assertEquals(List.of("speed", "unit"), List.copyOf(data.properties().keySet()));
    assertThrows(UnsupportedOperationException.class, () -> data.properties().put("other", speed));
    assertSame(unit, data.removeProperty("unit"));
    assertNull(data.removeProperty("unit"));
    assertEquals(List.of("speed"), List.copyOf(data.properties().keySet()));
    assertEquals(0, data.flags());
  }

  @Test
  void slotsOfOneVariableHaveTheirPropertiesTogether() {
    UrbiObject speed = root.cloned();
    UrbiObject unit = root.cloned();
    SlotData other = new SlotData();
    data.setProperty("speed", speed);
    other.setProperty("unit", unit);
    TreeMap<String, UrbiObject> all = new TreeMap<>();
    data.shareProperties(all);
    other.shareProperties(all);
    assertSame(unit, data.property("unit"));
    assertSame(speed, other.property("speed"));
  }

  @Test
  void onlyWhoIsConstantSaysSo() {
    assertFalse(data.isConstant());
    data.setConstant(true);
    assertTrue(data.isConstant());
    assertEquals(Shape.WRITE_SPECIAL, data.flags());
    data.setConstant(false);
    assertFalse(data.isConstant());
    assertEquals(0, data.flags());
  }

  /** Whatever looks at an assignment makes the slot one whose assignments are looked at. */
  @Test
  void whatLooksAtAssignmentsIsThereUntilItIsTakenAway() {
    kept(SlotData::changed, SlotData::setChanged);
    kept(SlotData::setter, SlotData::setSetter);
    kept(SlotData::updateHook, SlotData::setUpdateHook);
    kept(SlotData::least, SlotData::setLeast);
    kept(SlotData::most, SlotData::setMost);
  }

  private void kept(
      Function<SlotData, @Nullable UrbiObject> get,
      BiConsumer<SlotData, @Nullable UrbiObject> set) {
    UrbiObject kept = root.cloned();
    assertNull(get.apply(data));
    set.accept(data, kept);
    assertSame(kept, get.apply(data));
    assertEquals(Shape.WRITE_SPECIAL, data.flags());
    set.accept(data, null);
    assertEquals(0, data.flags());
  }

  @Test
  void whoHasAGetterIsReadAndAssignedDifferently() {
    UrbiObject getter = root.cloned();
    data.setGetter(getter);
    assertSame(getter, data.getter());
    assertEquals(Shape.WRITE_SPECIAL | Shape.READ_SPECIAL, data.flags());
  }

  @Test
  void conditionsThatReadItHearWhenItIsRemoved() {
    assertFalse(data.isRemoved());
    int[] told = {0};
    Dependencies dependents = new Dependencies("x");
    dependents.add(() -> told[0]++);
    data.setDependents(dependents);
    assertSame(dependents, data.dependents());
    assertEquals(Shape.WRITE_SPECIAL, data.flags());
    data.remove();
    assertTrue(data.isRemoved());
    assertEquals(1, told[0]);
  }
}
