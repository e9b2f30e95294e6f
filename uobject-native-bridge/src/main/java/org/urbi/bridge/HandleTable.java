package org.urbi.bridge;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Maps numbers, from 1, to objects that C++ code refers to. Any thread can look them up without a
 * lock.
 */
final class HandleTable<T> {
  private static final int FIRST_CAPACITY = 16;

  private final ArrayDeque<Integer> free = new ArrayDeque<>();
  private volatile Object[] all = new Object[FIRST_CAPACITY];
  private int used;

  /** Gives something a number. */
  synchronized long add(T thing) {
    Integer place = free.poll();
    if (place == null) {
      if (used == all.length) {
        all = Arrays.copyOf(all, 2 * used);
      }
      place = used++;
    }
    // Writing the array again publishes the element.
    Object[] present = all;
    present[place] = thing;
    all = present;
    return place + 1L;
  }

  /** The thing of that number, or null. */
  // Only values of T come in.
  @SuppressWarnings("unchecked")
  @Nullable T find(long number) {
    Object[] present = all;
    return number >= 1 && number <= present.length ? (T) present[(int) number - 1] : null;
  }

  /** The thing of that number, which is given to another one. */
  synchronized @Nullable T remove(long number) {
    T thing = find(number);
    if (thing != null) {
      all[(int) number - 1] = null;
      free.add((int) number - 1);
    }
    return thing;
  }

  /** All there are. */
  // Only values of T come in.
  @SuppressWarnings("unchecked")
  synchronized List<T> all() {
    List<T> things = new ArrayList<>();
    for (Object each : all) {
      if (each != null) {
        things.add((T) each);
      }
    }
    return things;
  }
}
