package org.urbi.kernel.object;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Several slots that an object gets together, by their names or by those of a kind. */
class SlotsAtOnceTest {
  private final World world = new World();
  private final UrbiObject root = world.values().object;
  private final Symbol place = world.symbol("place");
  private final Symbol calls = world.symbol("calls");
  private final SlotNames names = new SlotNames(place, calls);

  private UrbiObject value() {
    return root.cloned();
  }

  private UrbiObject withSlots(int count) {
    UrbiObject object = root.cloned();
    for (int i = 0; i < count; i++) {
      object.addSlot(world.symbol("own" + i), value());
    }
    return object;
  }

  /** More than 64 slots are in a table. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 60, 64, 70})
  void theyStandBehindThoseThatAreThere(int before) {
    UrbiObject object = withSlots(before);
    Symbol[] more =
        IntStream.range(0, 5).mapToObj(i -> world.symbol("new" + i)).toArray(Symbol[]::new);
    UrbiObject[] values = {value(), value(), value(), value(), value()};
    object.addSlots(more, values);
    for (int i = 0; i < more.length; i++) {
      assertSame(values[i], object.localSlot(more[i]));
    }
    List<Symbol> all = List.of(object.localSlotNames());
    assertEquals(List.of(more), all.subList(before, before + 5));
    assertEquals(all.stream().map(object::existingSlot).toList(), object.localSlotValues());
    object.addSlot(place, value());
    assertEquals(before + 6, object.localSlotValues().size());
  }

  @Test
  void theValuesHaveNoHolesWhereSlotsWereRemoved() {
    UrbiObject object = withSlots(70);
    object.removeSlot(world.symbol("own3"));
    assertEquals(
        Arrays.stream(object.localSlotNames()).map(object::existingSlot).toList(),
        object.localSlotValues());
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 2, 64, 70})
  void slotsOfThatNameAreReplacedAndStandAtTheEnd(int before) {
    UrbiObject object = withSlots(before);
    object.addSlot(calls, value());
    object.addSlot(world.symbol("last"), value());
    for (int i = 0; i < 3; i++) {
      UrbiObject where = value();
      UrbiObject who = value();
      names.put(object, where, who);
      assertSame(where, object.localSlot(place));
      assertSame(who, object.localSlot(calls));
      List<Symbol> all = List.of(object.localSlotNames());
      assertEquals(before + 3, all.size());
      assertEquals(List.of(place, calls), all.subList(before + 1, before + 3));
    }
  }

  @Test
  void objectsOfOneKindHaveOneShapeHoweverTheyGotTheSlots() {
    UrbiObject first = withSlots(1);
    UrbiObject second = withSlots(1);
    UrbiObject third = withSlots(1);
    names.put(first, value(), value());
    names.put(second, value(), value());
    third.addSlot(place, value());
    third.addSlot(calls, value());
    assertSame(first.shape(), second.shape());
    assertSame(first.shape(), third.shape());
  }

  /** Places in the code remember where they have found a name. */
  @Test
  void whoHasFoundTheNameElsewhereLooksAgain() {
    UrbiObject object = root.cloned();
    assertNull(object.cloned().lookup(place));
    int known = world.remember(place);
    names.put(object, value(), value());
    assertNotEquals(known, place.epoch());
  }
}
