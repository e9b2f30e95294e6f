package org.urbi.kernel.object;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** From 65 slots on an object has a table of them, with holes where some have been removed. */
class ManySlotsOfOneTest {
  private final World world = new World();
  private final UrbiObject root = world.values().object;

  private Symbol name(int i) {
    return world.symbol("slot" + i);
  }

  /** Slots come and go; now many, now few. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void slotsAreFoundWhateverWasRemoved(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    UrbiObject object = root.cloned();
    UrbiObject heir = object.cloned();
    Map<Symbol, UrbiObject> expected = new LinkedHashMap<>();
    for (int i = 0; i < 3000; i++) {
      boolean grows = i / 500 % 2 == 0;
      Symbol name = name(random.nextInt(300));
      if (expected.containsKey(name)) {
        if (!grows || random.nextInt(4) == 0) {
          assertTrue(object.removeSlot(name));
          expected.remove(name);
        } else {
          UrbiObject other = root.cloned();
          object.setSlotAt(object.shape().indexOf(name), other);
          expected.put(name, other);
        }
      } else if (grows || random.nextInt(4) == 0) {
        UrbiObject made = root.cloned();
        object.addSlot(name, made);
        expected.put(name, made);
      } else {
        assertFalse(object.removeSlot(name));
      }
      assertSame(expected.get(name), object.localSlot(name));
      assertSame(expected.get(name), heir.lookup(name));
      if (i % 50 == 0) {
        assertArrayEquals(expected.keySet().toArray(), object.localSlotNames());
        expected.forEach((each, value) -> assertSame(value, object.existingSlot(each)));
        assertTrue(object.shape().size() <= Math.max(65, 2 * expected.size() + 2), "holes stay");
      }
    }
  }

  private Shape shape(int count) {
    Shape shape = root.cloneShape();
    for (int i = 0; i < count; i++) {
      shape = shape.with(name(i));
    }
    return shape;
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 10, 63, 64, 65, 66, 129, 200})
  void whatIsSpecialOfASlotGoesWithIt(int count) {
    Shape shape = shape(count);
    assertEquals(count, shape.size());
    assertEquals(count > 64, shape.leavesHoles());
    int last = count - 1;
    assertSame(name(last), shape.nameAt(last));
    assertFalse(shape.writeSpecial(last));
    assertFalse(shape.readSpecial(last));
    shape = shape.withFlags(last, Shape.READ_SPECIAL);
    assertTrue(shape.readSpecial(last));
    assertFalse(shape.writeSpecial(last));
    shape = shape.withFlags(last, (byte) (Shape.READ_SPECIAL | Shape.WRITE_SPECIAL));
    assertTrue(shape.readSpecial(last) && shape.writeSpecial(last));
    assertFalse(count > 1 && shape.readSpecial(0));
    shape = shape.withProtos(new UrbiObject[] {root});
    assertTrue(shape.readSpecial(shape.indexOf(name(last))));
    for (int i = 0; i < last; i++) {
      shape = shape.without(shape.indexOf(name(i)));
    }
    assertEquals(-1, last == 0 ? -1 : shape.indexOf(name(0)));
    assertEquals(count > 64, shape.isSparse());
    shape = shape.compact();
    assertFalse(shape.leavesHoles());
    assertEquals(0, shape.indexOf(name(last)));
    assertTrue(shape.readSpecial(0) && shape.writeSpecial(0));
    shape = shape.with(name(0));
    assertFalse(shape.readSpecial(1));
  }

  @Test
  void whatIsNotSparseKeepsItsTable() {
    Shape shape = shape(200);
    for (int i = 0; i < 100; i++) {
      assertFalse(shape.isSparse(), i + " holes");
      shape = shape.without(shape.indexOf(name(i)));
    }
    assertFalse(shape.isSparse());
    assertEquals(200, shape.size());
    shape = shape.without(shape.indexOf(name(100)));
    assertTrue(shape.isSparse());
    shape = shape.compact();
    assertEquals(99, shape.size());
    assertTrue(shape.leavesHoles());
    assertSame(name(101), shape.nameAt(0));
  }

  /** A place in the code that has seen the slot there looks again when another object gets it. */
  @Test
  void aNewSlotInATableIsToldToWhoFoundItElsewhere() {
    UrbiObject object = root.cloned();
    for (int i = 0; i < 70; i++) {
      object.addSlot(name(i), root.cloned());
    }
    long before = name(100).epoch;
    object.addSlot(name(100), root.cloned());
    assertTrue(name(100).epoch > before);
  }

  /** Names that are used for a while leave nothing behind in the shape that they were added to. */
  @Test
  void shapesOfSharedNamesAreShared() {
    Shape root = this.root.cloneShape();
    List<Shape> kept = new ArrayList<>();
    for (int i = 0; i < 100; i++) {
      kept.add(root.with(name(i)));
    }
    for (int i = 0; i < 100; i++) {
      assertSame(kept.get(i), root.with(name(i)));
    }
  }
}
