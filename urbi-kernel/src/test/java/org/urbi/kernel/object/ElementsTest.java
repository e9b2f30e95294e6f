package org.urbi.kernel.object;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.ConcurrentModificationException;
import java.util.Iterator;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The elements of a list behave as those of {@link ArrayList}, wherever their ring begins. */
class ElementsTest {
  private final Values values = new World().values();
  private final List<UrbiObject> known = new ArrayList<>();

  private UrbiObject element() {
    UrbiObject made = values.number(known.size());
    known.add(made);
    return made;
  }

  private List<UrbiObject> elements(int count) {
    List<UrbiObject> made = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      made.add(element());
    }
    return made;
  }

  private static final Comparator<UrbiObject> DOWN =
      Comparator.comparingDouble((UrbiObject each) -> ((UrbiFloat) each).value()).reversed();

  private static void same(List<UrbiObject> expected, Elements actual) {
    assertEquals(expected.size(), actual.size());
    assertArrayEquals(expected.toArray(), actual.toArray());
    for (int i = 0; i < expected.size(); i++) {
      assertSame(expected.get(i), actual.get(i));
    }
  }

  /** Everything that lists can do, in any order. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  void whateverIsDoneItIsAsWithAnyList(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    List<UrbiObject> expected = new ArrayList<>();
    Elements actual = new Elements((int) seed * 3);
    for (int i = 0; i < 2000; i++) {
      int size = expected.size();
      switch (random.nextInt(size > 40 ? 14 : 10)) {
        case 0, 1 -> {
          UrbiObject first = element();
          expected.addFirst(first);
          actual.addFirst(first);
        }
        case 2, 3 -> {
          UrbiObject last = element();
          expected.add(last);
          assertTrue(actual.add(last));
        }
        case 4 -> {
          int at = random.nextInt(size + 1);
          UrbiObject one = element();
          expected.add(at, one);
          actual.add(at, one);
        }
        case 5 -> {
          List<UrbiObject> several = elements(random.nextInt(12));
          assertEquals(expected.addAll(several), actual.addAll(several));
        }
        case 6 -> {
          if (size > 0) {
            int at = random.nextInt(size);
            UrbiObject one = element();
            assertSame(expected.set(at, one), actual.set(at, one));
          }
        }
        case 7 -> {
          expected.sort(DOWN);
          actual.sort(DOWN);
        }
        case 8 -> {
          UrbiObject one = size == 0 ? element() : expected.get(random.nextInt(size));
          assertEquals(
              expected.removeIf(each -> each == one), actual.removeIf(each -> each == one));
        }
        case 9 -> {
          UrbiObject stranger = element();
          assertFalse(actual.removeIf(each -> each == stranger));
        }
        case 10, 11 -> {
          int at = random.nextInt(size);
          assertSame(expected.remove(at), actual.remove(at));
        }
        case 12 -> {
          assertSame(expected.removeFirst(), actual.removeFirst());
          assertSame(expected.removeLast(), actual.removeLast());
        }
        default -> {
          if (random.nextInt(20) == 0) {
            expected.clear();
            actual.clear();
          }
        }
      }
      same(expected, actual);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 7, 8, 9, 15, 16, 17, 33})
  void aCopyHasTheSameElements(int count) {
    List<UrbiObject> all = elements(count);
    Elements copy = new Elements(all);
    same(all, copy);
    UrbiObject more = element();
    copy.add(more);
    all.add(more);
    same(all, copy);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 5, 8, 12})
  void whatIsOutsideIsRefused(int count) {
    Elements some = new Elements(elements(count));
    UrbiObject other = element();
    for (int outside : new int[] {-1, count + 1}) {
      assertThrows(IndexOutOfBoundsException.class, () -> some.get(outside));
      assertThrows(IndexOutOfBoundsException.class, () -> some.set(outside, other));
      assertThrows(IndexOutOfBoundsException.class, () -> some.remove(outside));
      assertThrows(IndexOutOfBoundsException.class, () -> some.add(outside, other));
    }
    assertThrows(IndexOutOfBoundsException.class, () -> some.get(count));
    assertThrows(IndexOutOfBoundsException.class, () -> some.set(count, other));
    assertThrows(IndexOutOfBoundsException.class, () -> some.remove(count));
    assertEquals(count, some.size());
  }

  @Test
  void whoGoesThroughThemIsToldOfChanges() {
    List<java.util.function.Consumer<Elements>> changes =
        List.of(
            some -> some.add(element()),
            some -> some.addFirst(element()),
            some -> some.addAll(elements(2)),
            some -> some.remove(1),
            some -> some.removeIf(each -> true),
            some -> some.sort(DOWN),
            Elements::clear);
    for (var change : changes) {
      Elements some = new Elements(elements(5));
      Iterator<UrbiObject> each = some.iterator();
      each.next();
      change.accept(some);
      assertThrows(ConcurrentModificationException.class, each::next);
    }
  }
}
