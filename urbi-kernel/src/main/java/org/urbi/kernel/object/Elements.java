package org.urbi.kernel.object;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
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
      for (int i = 0; i < index; i++) {
        ring[at(i)] = ring[at(i + 1)];
      }
    } else {
      for (int i = size; i > index; i--) {
        ring[at(i)] = ring[at(i - 1)];
      }
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
    for (Object element : added) {
      ring[at(size++)] = (UrbiObject) element;
    }
    return added.length > 0;
  }

  @Override
  public UrbiObject remove(int index) {
    Objects.checkIndex(index, size);
    modCount++;
    UrbiObject removed = ring[at(index)];
    if (index < size / 2) {
      for (int i = index; i > 0; i--) {
        ring[at(i)] = ring[at(i - 1)];
      }
      ring[head] = null;
      head = at(1);
    } else {
      for (int i = index; i < size - 1; i++) {
        ring[at(i)] = ring[at(i + 1)];
      }
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

  private void grow(int capacity) {
    UrbiObject[] wider = new UrbiObject[ringFor(Math.max(capacity, 2 * ring.length))];
    int straight = Math.min(size, ring.length - head);
    System.arraycopy(ring, head, wider, 0, straight);
    System.arraycopy(ring, 0, wider, straight, size - straight);
    ring = wider;
    head = 0;
  }
}
