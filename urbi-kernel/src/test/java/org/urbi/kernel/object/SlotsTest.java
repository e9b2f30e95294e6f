package org.urbi.kernel.object;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What an object has of its own: slots by name and by index, their data, an identity. */
class SlotsTest {
  private final World world = new World();
  private final UrbiObject root = world.values().object;

  private Symbol name(String text) {
    return world.symbol(text);
  }

  private UrbiObject value() {
    return root.cloned();
  }

  @Test
  void aSlotIsFoundByItsNameAndAtItsIndex() {
    UrbiObject object = root.cloned();
    UrbiObject first = value();
    UrbiObject second = value();
    object.addSlot(name("first"), first);
    object.addSlot(name("second"), second);
    assertSame(first, object.localSlot(name("first")));
    assertSame(second, object.localSlot(name("second")));
    assertEquals(0, object.shape().indexOf(name("first")));
    assertEquals(1, object.shape().indexOf(name("second")));
    assertEquals(-1, object.shape().indexOf(name("third")));
    assertSame(second, object.slotAt(1));
    assertNull(object.localSlot(name("third")));
    assertTrue(object.hasLocalSlot(name("first")));
    assertTrue(object.hasLocalSlot(name("second")));
    assertFalse(object.hasLocalSlot(name("third")));
  }

  @Test
  void aSlotIsAssignedAtItsIndex() {
    UrbiObject object = root.cloned();
    object.addSlot(name("a"), value());
    object.addSlot(name("b"), value());
    UrbiObject other = value();
    object.setSlotAt(1, other);
    assertSame(other, object.localSlot(name("b")));
  }

  /** Places in the code remember what they have to call. */
  @Test
  void whoRemembersCodeLooksAgainWhenItIsReplaced() {
    UrbiObject object = root.cloned();
    object.addSlot(name("a"), new UrbiCode(root.cloneShape()) {});
    object.addSlot(name("b"), value());
    long code = name("a").epoch;
    long plain = name("b").epoch;
    object.setSlotAt(0, value());
    object.setSlotAt(1, value());
    assertTrue(name("a").epoch > code);
    assertEquals(plain, name("b").epoch);
  }

  /** Few slots and many are kept differently. */
  @ParameterizedTest
  @ValueSource(ints = {1, 4, 5, 8, 9, 10, 100})
  void anyNumberOfSlotsIsFound(int count) {
    UrbiObject object = root.cloned();
    List<UrbiObject> values = new ArrayList<>();
    Symbol[] names = new Symbol[count];
    for (int i = 0; i < count; i++) {
      values.add(value());
      names[i] = name("slot" + i);
      object.addSlot(names[i], values.get(i));
    }
    for (int i = 0; i < count; i++) {
      assertSame(values.get(i), object.localSlot(names[i]));
      assertEquals(i, object.shape().indexOf(names[i]));
    }
    assertEquals(-1, object.shape().indexOf(name("missing")));
    assertArrayEquals(names, object.localSlotNames());
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 5, 9, 20})
  void theOthersStayWhenOneIsRemoved(int count) {
    for (int gone = 0; gone < count; gone++) {
      UrbiObject object = root.cloned();
      List<UrbiObject> values = new ArrayList<>();
      for (int i = 0; i < count; i++) {
        values.add(value());
        object.addSlot(name("slot" + i), values.get(i));
      }
      assertTrue(object.removeSlot(name("slot" + gone)));
      for (int i = 0; i < count; i++) {
        assertSame(i == gone ? null : values.get(i), object.localSlot(name("slot" + i)));
      }
      UrbiObject again = value();
      object.addSlot(name("slot" + gone), again);
      assertSame(again, object.localSlot(name("slot" + gone)));
      assertEquals(count - 1, object.shape().indexOf(name("slot" + gone)));
      // There is room for more.
      for (int i = 0; i < 10; i++) {
        object.addSlot(name("more" + i), again);
      }
    }
  }

  @Test
  void whatIsNotThereCannotBeRemoved() {
    UrbiObject object = root.cloned();
    assertFalse(object.removeSlot(name("a")));
    object.addSlot(name("a"), value());
    assertFalse(object.removeSlot(name("b")));
    assertTrue(object.removeSlot(name("a")));
    assertFalse(object.removeSlot(name("a")));
    assertEquals(0, object.localSlotNames().length);
  }

  @Test
  void objectsBuiltAlikeHaveOneShape() {
    UrbiObject one = root.cloned();
    UrbiObject two = root.cloned();
    assertSame(one.shape(), two.shape());
    one.addSlot(name("a"), value());
    assertNotSame(one.shape(), two.shape());
    two.addSlot(name("a"), value());
    assertSame(one.shape(), two.shape());
    one.addSlot(name("b"), value());
    two.addSlot(name("c"), value());
    assertNotSame(one.shape(), two.shape());
    assertNotSame(one.cloned().shape(), two.cloned().shape());
  }

  @Test
  void flagsAndPrototypesOfOneDoNotChangeTheOther() {
    UrbiObject one = root.cloned();
    UrbiObject two = root.cloned();
    one.addSlot(name("a"), value());
    two.addSlot(name("a"), value());
    one.ensureSlotData(name("a")).setConstant(true);
    one.slotDataChanged(name("a"));
    assertTrue(one.shape().writeSpecial(0));
    assertFalse(two.shape().writeSpecial(0));
    two.setProtos(value());
    assertSame(root, one.protos()[0]);
  }

  @Test
  void aWrittenSlotIsSpecialForEachReasonAlone() {
    for (int reason = 0; reason < 6; reason++) {
      UrbiObject object = root.cloned();
      object.addSlot(name("before"), value());
      object.addSlot(name("a"), value());
      SlotData data = object.ensureSlotData(name("a"));
      object.slotDataChanged(name("a"));
      assertFalse(object.shape().writeSpecial(1));
      switch (reason) {
        case 0 -> data.setConstant(true);
        case 1 -> data.setChanged(value());
        case 2 -> data.setSetter(value());
        case 3 -> data.setDependents(new Dependencies("x"));
        case 4 -> data.setGetter(value());
        default -> data.setBlending(new SlotBlending() {});
      }
      object.slotDataChanged(name("a"));
      assertTrue(object.shape().writeSpecial(1), "reason " + reason);
      assertEquals(reason == 4, object.shape().readSpecial(1), "reason " + reason);
      assertFalse(object.shape().writeSpecial(0));
      assertFalse(object.shape().readSpecial(0));
    }
  }

  @Test
  void flagsStayWithTheirSlot() {
    UrbiObject object = root.cloned();
    for (String slot : List.of("a", "b", "c", "d")) {
      object.addSlot(name(slot), value());
    }
    object.ensureSlotData(name("c")).setConstant(true);
    object.slotDataChanged(name("c"));
    object.removeSlot(name("b"));
    assertTrue(object.shape().writeSpecial(1));
    assertFalse(object.shape().writeSpecial(2));
    object.addSlot(name("e"), value());
    assertTrue(object.shape().writeSpecial(1));
    assertFalse(object.shape().writeSpecial(3));
    object.removeSlot(name("e"));
    assertTrue(object.shape().writeSpecial(1));
    object.setProtos(value());
    assertTrue(object.shape().writeSpecial(1));
  }

  @Test
  void aSlotThatComesBackHasNothingOfTheOneBefore() {
    UrbiObject object = root.cloned();
    object.addSlot(name("a"), value());
    SlotData old = object.ensureSlotData(name("a"));
    old.setConstant(true);
    object.slotDataChanged(name("a"));
    assertSame(old, object.slotData(name("a")));
    assertSame(old, object.ensureSlotData(name("a")));
    assertFalse(old.isRemoved());
    object.removeSlot(name("a"));
    assertTrue(old.isRemoved());
    assertNull(object.slotData(name("a")));
    object.addSlot(name("a"), value());
    assertFalse(object.shape().writeSpecial(0));
  }

  @Test
  void plainSlotsHaveNoData() {
    UrbiObject object = root.cloned();
    assertNull(object.slotData(name("a")));
    object.addSlot(name("a"), value());
    assertNull(object.slotData(name("a")));
    object.ensureSlotData(name("b"));
    assertNull(object.slotData(name("a")));
    // What is no slot yet has no flags either.
    object.slotDataChanged(name("b"));
  }

  @Test
  void everyObjectHasANumberOfItsOwn() {
    UrbiObject one = root.cloned();
    UrbiObject two = root.cloned();
    long first = one.uid();
    assertEquals(0x7f00_0010L, first);
    assertEquals(0x7f00_0020L, two.uid());
    assertEquals(first, one.uid());
  }

  @Test
  void everyObjectKnowsItsWorld() {
    assertSame(world, root.cloned().world());
    assertSame(world, root.shape().world());
    assertNotSame(world, new World().values().object.world());
  }

  @Test
  void objectsThatGetTheSameSlotsTogetherHaveOneShape() {
    SlotNames names = new SlotNames(name("a"), name("b"));
    UrbiObject first = value();
    UrbiObject second = value();
    UrbiObject made = root.clonedWith(names, first, second);
    assertSame(first, made.localSlot(name("a")));
    assertSame(second, made.localSlot(name("b")));
    UrbiObject like = root.clonedWith(names, second, first);
    assertSame(made.shape(), like.shape());
    assertSame(second, like.localSlot(name("a")));
    UrbiObject other = root.cloned().clonedWith(names, first, second);
    assertNotSame(made.shape(), other.shape());
    assertSame(first, other.localSlot(name("a")));
  }

  @Test
  void whatItKeepsForOthersIsNotInherited() {
    UrbiObject object = root.cloned();
    assertNull(object.companion());
    object.addSlot(name("a"), value());
    assertNull(object.companion());
    UrbiObject.Companion kept = new UrbiObject.Companion() {};
    object.setCompanion(kept);
    assertSame(kept, object.companion());
    assertNull(object.cloned().companion());
  }
}
