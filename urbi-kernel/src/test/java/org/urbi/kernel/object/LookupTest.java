package org.urbi.kernel.object;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Slots are inherited from prototypes, and who remembers where one was learns when it moves. */
class LookupTest {
  private final World world = new World();
  private final UrbiObject root = world.values().object;
  private final Symbol x = world.symbol("x");
  private final Symbol y = world.symbol("y");

  private UrbiObject with(Symbol name, UrbiObject... protos) {
    UrbiObject object = root.cloned();
    if (protos.length > 0) {
      object.setProtos(protos);
    }
    object.addSlot(name, root.cloned());
    return object;
  }

  /** An object of that many prototypes, one behind the other, below the given one. */
  private static UrbiObject below(UrbiObject top, int generations) {
    UrbiObject at = top;
    for (int i = 0; i < generations; i++) {
      at = at.cloned();
    }
    return at;
  }

  // ------------------------------------------------------------------ inheritance

  /** More than 64 generations are looked through in another way than few. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 63, 64, 65, 200})
  void aSlotIsInheritedOverGenerations(int generations) {
    UrbiObject top = with(x);
    UrbiObject heir = below(top, generations);
    assertSame(top, heir.locate(x));
    assertSame(top.localSlot(x), heir.lookup(x));
    assertNull(heir.locate(y));
    assertNull(heir.lookup(y));
    assertTrue(heir.isA(top));
    assertTrue(heir.isA(root));
    assertTrue(heir.isA(heir));
    assertEquals(generations == 0, top.isA(heir));
    assertFalse(heir.isA(world.values().floatProto));
  }

  @Test
  void theNearestOneCounts() {
    UrbiObject top = with(x);
    UrbiObject middle = top.cloned();
    UrbiObject heir = middle.cloned();
    middle.addSlot(x, root.cloned());
    assertSame(middle, heir.locate(x));
    heir.addSlot(x, root.cloned());
    assertSame(heir, heir.locate(x));
  }

  @Test
  void theFirstPrototypeIsSearchedToItsRootBeforeTheSecond() {
    UrbiObject left = with(x).cloned();
    UrbiObject right = with(x);
    right.addSlot(y, root.cloned());
    UrbiObject heir = root.cloned();
    heir.setProtos(left, right);
    assertSame(left.protos()[0], heir.locate(x));
    assertSame(right, heir.locate(y));
    assertSame(right, heir.cloned().locate(y));
    assertTrue(heir.isA(left));
    assertTrue(heir.isA(right));
    assertTrue(heir.isA(root));
    assertFalse(heir.isA(world.values().nil));
  }

  @Test
  void theLastOneAddedComesFirst() {
    UrbiObject left = with(x);
    UrbiObject right = with(x);
    UrbiObject heir = left.cloned();
    heir.addProto(right);
    assertArrayEquals(new UrbiObject[] {right, left}, heir.protos());
    assertSame(right, heir.locate(x));
    // Known already, it stays where it is.
    heir.addProto(left);
    assertArrayEquals(new UrbiObject[] {right, left}, heir.protos());
    heir.removeProto(right);
    assertArrayEquals(new UrbiObject[] {left}, heir.protos());
    assertSame(left, heir.locate(x));
    heir.removeProto(right);
    assertArrayEquals(new UrbiObject[] {left}, heir.protos());
    heir.removeProto(left);
    assertEquals(0, heir.protos().length);
    assertNull(heir.locate(x));
    assertFalse(heir.isA(left));
  }

  @Test
  void prototypesInACircleAreSearchedOnce() {
    UrbiObject one = root.cloned();
    UrbiObject two = one.cloned();
    UrbiObject three = with(y);
    one.setProtos(two, three);
    assertNull(one.locate(x));
    assertSame(three, two.locate(y));
    assertFalse(one.isA(world.values().floatProto));
    assertTrue(one.isA(three));
    UrbiObject alone = root.cloned();
    alone.setProtos(alone);
    assertNull(alone.locate(x));
    assertFalse(alone.isA(root));
  }

  @Test
  void theArrayGivenIsCopied() {
    UrbiObject[] protos = {with(x)};
    UrbiObject heir = root.cloned();
    heir.setProtos(protos);
    protos[0] = root;
    assertTrue(heir.lookup(x) != null);
  }

  // ------------------------------------------------------------------ what is remembered

  @Test
  void aSlotThatComesOrGoesInAPrototypeIsTold() {
    UrbiObject top = root.cloned();
    UrbiObject heir = top.cloned();
    int before = x.epoch();
    int other = y.epoch();
    top.addSlot(x, root.cloned());
    assertNotEquals(before, x.epoch());
    before = x.epoch();
    top.removeSlot(x);
    assertNotEquals(before, x.epoch());
    assertEquals(other, y.epoch());
    assertNull(heir.locate(x));
  }

  @Test
  void aSlotThatMovesIsToldAndThoseBeforeItAreNot() {
    Symbol z = world.symbol("z");
    UrbiObject top = root.cloned();
    top.addSlot(x, root.cloned());
    top.addSlot(y, root.cloned());
    top.addSlot(z, root.cloned());
    top.cloned();
    int first = x.epoch();
    int second = y.epoch();
    int third = z.epoch();
    top.removeSlot(y);
    assertEquals(first, x.epoch());
    assertNotEquals(second, y.epoch());
    assertNotEquals(third, z.epoch());
  }

  @Test
  void whatNobodyInheritsFromDisturbsNobody() {
    UrbiObject object = root.cloned();
    object.uid();
    int before = x.epoch();
    int behind = y.epoch();
    object.addSlot(x, root.cloned());
    object.addSlot(y, root.cloned());
    object.ensureSlotData(x).setGetter(root.cloned());
    object.slotDataChanged(x);
    object.setProtos(root.cloned());
    object.removeSlot(x);
    assertEquals(before, x.epoch());
    assertEquals(behind, y.epoch());
  }

  @Test
  void aSlotThatBecomesSpecialIsTold() {
    UrbiObject top = with(x);
    top.cloned();
    int before = x.epoch();
    top.ensureSlotData(x).setProperty("note", root);
    top.slotDataChanged(x);
    assertEquals(before, x.epoch());
    top.ensureSlotData(x).setGetter(root.cloned());
    top.slotDataChanged(x);
    assertNotEquals(before, x.epoch());
    assertTrue(top.shape().readSpecial(0));
  }

  @Test
  void newPrototypesOfAPrototypeAreToldForEveryName() {
    UrbiObject top = root.cloned();
    UrbiObject heir = top.cloned();
    int first = world.remember(x);
    int second = world.remember(y);
    top.setProtos(with(x));
    assertNotEquals(first, x.epoch());
    assertNotEquals(second, y.epoch());
    assertTrue(heir.lookup(x) != null);
    // Nobody has remembered anything since.
    first = x.epoch();
    top.setProtos(with(y));
    assertEquals(first, x.epoch());
    assertEquals(first, world.remember(x));
    top.setProtos(with(x));
    assertNotEquals(first, x.epoch());
  }

  @Test
  void anObjectIsAPrototypeHoweverItBecameOne() {
    UrbiObject made = root.cloned();
    UrbiObject added = root.cloned();
    made.cloneShape();
    root.cloned().addProto(added);
    int before = x.epoch();
    made.addSlot(x, root.cloned());
    assertNotEquals(before, x.epoch());
    before = x.epoch();
    added.addSlot(x, root.cloned());
    assertNotEquals(before, x.epoch());
  }

  /**
   * Prototypes that have several themselves, in circles too, and that change in between: what is
   * remembered of them is what a walk finds.
   */
  @Test
  void ancestorsAreThoseOfTheMoment() {
    var random = new java.util.Random(1);
    for (int round = 0; round < 50; round++) {
      UrbiObject[] objects = new UrbiObject[random.nextInt(2, 90)];
      for (int i = 0; i < objects.length; i++) {
        objects[i] = root.cloned();
      }
      for (int change = 0; change < 30; change++) {
        UrbiObject[] protos = new UrbiObject[random.nextInt(4)];
        for (int i = 0; i < protos.length; i++) {
          protos[i] = objects[random.nextInt(objects.length)];
        }
        UrbiObject changed = objects[random.nextInt(objects.length)];
        changed.setProtos(protos);
        UrbiObject holder = objects[random.nextInt(objects.length)];
        if (!holder.removeSlot(x)) {
          holder.addSlot(x, root);
        }
        UrbiObject from = random.nextBoolean() ? changed : objects[random.nextInt(objects.length)];
        var all = new java.util.LinkedHashSet<UrbiObject>();
        walk(from, all);
        assertSame(
            all.stream().filter(at -> at.localSlot(x) != null).findFirst().orElse(null),
            from.locate(x));
        for (UrbiObject other : objects) {
          assertEquals(all.contains(other), from.isA(other));
        }
      }
    }
  }

  /** What was an ancestor once is not kept alive by those who have found a slot in it. */
  @Test
  void formerAncestorsAreForgotten() throws InterruptedException {
    UrbiObject heir = root.cloned();
    var former = new java.lang.ref.WeakReference<>(with(x));
    heir.setProtos(java.util.Objects.requireNonNull(former.get()), with(y));
    assertTrue(heir.cloned().isA(java.util.Objects.requireNonNull(former.get())));
    heir.setProtos(root);
    for (int i = 0; i < 50 && former.get() != null; i++) {
      System.gc();
      Thread.sleep(10);
    }
    assertNull(former.get());
  }

  private static void walk(UrbiObject at, java.util.Set<UrbiObject> seen) {
    if (seen.add(at)) {
      for (UrbiObject proto : at.protos()) {
        walk(proto, seen);
      }
    }
  }
}
