package org.urbi.kernel.object;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.RandomAccess;
import java.util.function.Predicate;

/**
 * The elements of a list, in a ring buffer: adding and removing is fast at both ends, because
 * programs use lists as queues.
 */
public final class Elements extends AbstractList<UrbiObject> implements RandomAccess {
  private static final int FIRST_CAPACITY = 8;

  /** Its length is a power of two. */
  private UrbiObject[] ring;

  private int head;
  private int size;

  /** Creates an empty list with room for that many elements. */
  public Elements(int capacity) {
    ring = new UrbiObject[ringFor(capacity)];
  }

  /** A copy of the elements. */
  public Elements(Collection<? extends UrbiObject> elements) {
    this(elements.size());
    addAll(elements);
  }

  private static int ringFor(int capacity) {
    if (capacity <= FIRST_CAPACITY) {
      return capacity <= 2 ? 2 : FIRST_CAPACITY;
    }
    return Integer.highestOneBit(capacity - 1) << 1;
  }

  private int at(int index) {
    return (head + index) & (ring.length - 1);
  }

  @Override
  public int size() {
    return size;
  }

  @Override
  public UrbiObject get(int index) {
    return ring[at(Objects.checkIndex(index, size))];
  }

  @Override
  public UrbiObject set(int index, UrbiObject element) {
    int place = at(Objects.checkIndex(index, size));
    UrbiObject before = ring[place];
    ring[place] = element;
    return before;
  }

  @Override
  public void add(int index, UrbiObject element) {
    Objects.checkIndex(index, size + 1);
    modCount++;
    if (size == ring.length) {
      grow(size + 1);
    }
    if (index < size / 2) {
      head = (head - 1) & (ring.length - 1);
      moveForward(at(1), index);
    } else {
      moveBackward(at(index), size - index);
    }
    ring[at(index)] = element;
    size++;
  }

  @Override
  public boolean addAll(Collection<? extends UrbiObject> elements) {
    Object[] added = elements.toArray();
    modCount++;
    if (size + added.length > ring.length) {
      grow(size + added.length);
    }
    int straight = Math.min(added.length, ring.length - at(size));
    System.arraycopy(added, 0, ring, at(size), straight);
    System.arraycopy(added, straight, ring, 0, added.length - straight);
    size += added.length;
    return added.length > 0;
  }

  /**
   * Adds a part of other elements at the end, or of these.
   *
   * @param begin the index of the first one
   * @param end the index behind the last one
   */
  public void addRange(List<? extends UrbiObject> others, int begin, int end) {
    Objects.checkFromToIndex(begin, end, others.size());
    modCount++;
    if (size + end - begin > ring.length) {
      grow(size + end - begin);
    }
    for (int i = begin; i < end; i++) {
      ring[at(size++)] = others.get(i);
    }
  }

  @Override
  public UrbiObject remove(int index) {
    Objects.checkIndex(index, size);
    modCount++;
    UrbiObject removed = ring[at(index)];
    if (index < size / 2) {
      moveBackward(head, index);
      ring[head] = null;
      head = at(1);
    } else {
      moveForward(at(index + 1), size - 1 - index);
      ring[at(size - 1)] = null;
    }
    size--;
    return removed;
  }

  @Override
  public boolean removeIf(Predicate<? super UrbiObject> condition) {
    int kept = 0;
    for (int i = 0; i < size; i++) {
      UrbiObject element = ring[at(i)];
      if (!condition.test(element)) {
        ring[at(kept++)] = element;
      }
    }
    boolean removed = kept < size;
    for (int i = kept; i < size; i++) {
      ring[at(i)] = null;
    }
    size = kept;
    modCount++;
    return removed;
  }

  @Override
  public void clear() {
    modCount++;
    Arrays.fill(ring, null);
    head = 0;
    size = 0;
  }

  @Override
  public Object[] toArray() {
    Object[] all = new Object[size];
    int straight = Math.min(size, ring.length - head);
    System.arraycopy(ring, head, all, 0, straight);
    System.arraycopy(ring, 0, all, straight, size - straight);
    return all;
  }

  @Override
  public void sort(Comparator<? super UrbiObject> order) {
    UrbiObject[] sorted = Arrays.copyOf(toArray(), size, UrbiObject[].class);
    Arrays.sort(sorted, order);
    modCount++;
    head = 0;
    Arrays.fill(ring, null);
    System.arraycopy(sorted, 0, ring, 0, size);
  }

  /** Moves so many elements, of which the first is at that place of the ring, one place on. */
  private void moveBackward(int place, int count) {
    int straight = ring.length - place;
    if (count < straight) {
      System.arraycopy(ring, place, ring, place + 1, count);
    } else {
      System.arraycopy(ring, 0, ring, 1, count - straight);
      ring[0] = ring[ring.length - 1];
      System.arraycopy(ring, place, ring, place + 1, straight - 1);
    }
  }

  /** Moves so many elements, of which the first is at that place of the ring, one place back. */
  private void moveForward(int place, int count) {
    if (count == 0) {
      return;
    }
    int straight = Math.min(count, ring.length - place);
    if (place > 0) {
      System.arraycopy(ring, place, ring, place - 1, straight);
    } else {
      ring[ring.length - 1] = ring[0];
      System.arraycopy(ring, 1, ring, 0, straight - 1);
    }
    if (straight < count) {
      ring[ring.length - 1] = ring[0];
      System.arraycopy(ring, 1, ring, 0, count - straight - 1);
    }
  }

  private void grow(int capacity) {
    UrbiObject[] wider = new UrbiObject[ringFor(Math.max(capacity, 2 * ring.length))];
    int straight = Math.min(size, ring.length - head);
    System.arraycopy(ring, head, wider, 0, straight);
    System.arraycopy(ring, 0, wider, straight, size - straight);
    ring = wider;
    head = 0;
  }
}
