package org.urbi.kernel.object;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Numbers that compiled code keeps in slots, of which there is no object until somebody looks. */
class UnseenNumbersTest {
  private final World world = new World();
  private final Values values = world.values();
  private final UrbiObject owner = values.object.cloned();
  private final Shape shape;

  UnseenNumbersTest() {
    owner.addSlot(world.symbol("x"), values.object.cloned());
    shape = owner.shape();
  }

  private boolean set(double number) {
    return owner.setNumberAt(shape, 0, number, values.unseenShape);
  }

  private boolean hasNumber(double number) {
    return Double.doubleToRawLongBits(owner.numberAt(shape, 0))
        == Double.doubleToRawLongBits(number);
  }

  @Test
  void aSlotKeepsNumbersWithoutTheirObjects() {
    assertTrue(hasNumber(UrbiObject.NO_NUMBER));
    assertTrue(set(1.5));
    assertTrue(hasNumber(1.5));
    assertTrue(set(2.5));
    assertTrue(hasNumber(2.5));
  }

  /** Whoever has the object has a number that never changes. */
  @Test
  void whatWasSeenIsNotOverwritten() {
    set(1.5);
    set(2.5);
    UrbiFloat seen = (UrbiFloat) owner.slotAt(0);
    assertEquals(2.5, seen.value());
    assertSame(values.floatShape, seen.shape());
    assertTrue(hasNumber(2.5));
    assertTrue(set(3.5));
    assertEquals(2.5, seen.value());
    assertNotSame(seen, owner.slotAt(0));
    assertTrue(hasNumber(3.5));
  }

  @Test
  void objectsOfAnotherShapeAreLeftAlone() {
    set(1.5);
    owner.addSlot(world.symbol("y"), values.object.cloned());
    assertFalse(set(2.5));
    assertTrue(hasNumber(UrbiObject.NO_NUMBER));
    assertEquals(1.5, ((UrbiFloat) owner.slotAt(0)).value());
  }

  /** It may answer otherwise, as a number of the user's own. */
  @Test
  void aNumberWithSlotsOfItsOwnIsNoPlainOne() {
    set(1.5);
    owner.slotAt(0).addSlot(world.symbol("unit"), values.object.cloned());
    assertTrue(hasNumber(UrbiObject.NO_NUMBER));
  }
}
