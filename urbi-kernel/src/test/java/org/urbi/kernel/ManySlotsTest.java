package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.object.Elements;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.World;

/** Objects with very many slots, names that come and go, lists as queues, strings that change. */
class ManySlotsTest {
  private final World world = new World();

  private UrbiObject value(int number) {
    return world.values().number(number);
  }

  private UrbiObject object() {
    return world.values().object.cloned();
  }

  /** With a shape per slot this takes gigabytes and minutes. */
  @Test
  void aMillionSlotsTakeLinearTimeAndMemory() {
    UrbiObject object = object();
    UrbiObject last = null;
    for (int i = 0; i < 1_000_000; i++) {
      last = value(i);
      object.addSlot(world.symbol("slot" + i), last);
    }
    assertEquals(1_000_000, object.localSlotNames().length);
    assertSame(last, object.localSlot(world.symbol("slot999999")));
    for (int i = 0; i < 1_000_000; i++) {
      assertTrue(object.removeSlot(world.symbol("slot" + i)));
    }
    assertEquals(0, object.localSlotNames().length);
  }

  /** Adds and removes at random, and compares with what a map does. */
  @Test
  void slotsAreThoseOfAMapInTheOrderInWhichTheyCame() {
    for (int seed = 0; seed < 20; seed++) {
      Random random = new Random(seed);
      UrbiObject object = object();
      UrbiObject clone = object.cloned();
      Map<Symbol, UrbiObject> expected = new LinkedHashMap<>();
      for (int step = 0; step < 2000; step++) {
        Symbol name = world.symbol("s" + random.nextInt(50 + 10 * seed));
        if (expected.containsKey(name) && random.nextInt(3) > 0) {
          expected.remove(name);
          assertTrue(object.removeSlot(name));
        } else if (!expected.containsKey(name)) {
          UrbiObject value = value(step);
          expected.put(name, value);
          object.addSlot(name, value);
        } else {
          UrbiObject value = value(-step);
          expected.put(name, value);
          object.setSlotAt(object.shape().indexOf(name), value);
        }
        if (step % 100 == 0) {
          assertArrayEquals(expected.keySet().toArray(), object.localSlotNames());
          expected.forEach((key, value) -> assertSame(value, object.localSlot(key)));
          expected.forEach((key, value) -> assertSame(value, clone.lookup(key)));
        }
      }
    }
  }

  @Test
  void theNameOfAnObjectThatIsGoneIsForgottenWhenOthersCome() throws InterruptedException {
    WeakReference<Symbol> name = nameOfAnObjectThatIsGone();
    for (int i = 0; i < 100 && name.get() != null; i++) {
      System.gc();
      for (int other = 0; other < 100; other++) {
        object().addSlot(world.symbol("other" + i + "_" + other), value(1));
      }
      Thread.sleep(20);
    }
    assertNull(name.get());
  }

  private WeakReference<Symbol> nameOfAnObjectThatIsGone() {
    Symbol name = world.symbol("gone");
    object().addSlot(name, value(1));
    return new WeakReference<>(name);
  }

  @Test
  void elementsAreThoseOfAnArrayList() {
    for (int seed = 0; seed < 50; seed++) {
      Random random = new Random(seed);
      Elements elements = new Elements(random.nextInt(20));
      List<UrbiObject> expected = new ArrayList<>();
      for (int step = 0; step < 500; step++) {
        int at = random.nextInt(expected.size() + 1);
        UrbiObject value = value(random.nextInt(10));
        switch (random.nextInt(8)) {
          case 0, 1 -> {
            elements.add(at, value);
            expected.add(at, value);
          }
          case 2 -> {
            elements.addFirst(value);
            expected.addFirst(value);
          }
          case 3 -> {
            elements.addAll(List.of(value, value));
            expected.addAll(List.of(value, value));
          }
          case 4 -> {
            elements.sort((a, b) -> Long.compare(a.uid(), b.uid()));
            expected.sort((a, b) -> Long.compare(a.uid(), b.uid()));
          }
          case 5 -> {
            long odd = random.nextInt(3);
            elements.removeIf(each -> each.uid() / 16 % 3 == odd);
            expected.removeIf(each -> each.uid() / 16 % 3 == odd);
          }
          default -> {
            if (at < expected.size()) {
              assertSame(expected.remove(at), elements.remove(at));
            }
          }
        }
        assertEquals(expected, elements);
        assertArrayEquals(expected.toArray(), elements.toArray());
      }
    }
  }

  /** Each removal from the front of an array moves all that is behind it. */
  @Test
  void aListIsAQueue() {
    Elements elements = new Elements(0);
    for (int i = 0; i < 1_000_000; i++) {
      elements.addFirst(value(i));
    }
    for (int i = 0; i < 1_000_000; i++) {
      elements.removeFirst();
    }
    assertTrue(elements.isEmpty());
  }

  /** Where each change copies the whole string, this copies 10^12 characters. */
  @Test
  void aStringIsChangedInPlace() {
    UrbiString text = world.values().string("x".repeat(1_000_000));
    for (int i = 0; i < 1_000_000; i++) {
      text.replace(i, i + 1, "y");
    }
    assertEquals("y".repeat(1_000_000), text.value());
  }
}
