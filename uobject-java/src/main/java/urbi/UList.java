package urbi;

import java.util.AbstractList;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.RandomAccess;

/** A list of values. What is no {@link UValue} yet is made one by {@link UCast#toUValue}. */
public final class UList extends AbstractList<UValue> implements RandomAccess {
  private final UValueVector array;

  public UList() {
    array = new UValueVector();
  }

  /** The values of a collection, made with {@link UCast#toUValue}. */
  public UList(Collection<?> values) {
    array = new UValueVector();
    array.ensureCapacity(values.size());
    for (Object value : values) {
      array.add(UCast.toUValue(value));
    }
  }

  /** A list of these. */
  public static UList of(Object... values) {
    return new UList(java.util.Arrays.asList(values));
  }

  /** The contents themselves. */
  public UValueVector getArray() {
    return array;
  }

  @Override
  public UValue get(int index) {
    return array.get(index);
  }

  public UValue get(long index) {
    return array.get(Math.toIntExact(index));
  }

  @Override
  public int size() {
    return array.size();
  }

  @Override
  public UValue set(int index, UValue value) {
    return array.set(index, UCast.toUValue(value));
  }

  @Override
  public void add(int index, UValue value) {
    array.add(index, UCast.toUValue(value));
    modCount++;
  }

  @Override
  public UValue remove(int index) {
    modCount++;
    return array.remove(index);
  }

  /** Appends a value. */
  public UList push_back(Object value) {
    add(UCast.toUValue(value));
    return this;
  }

  /** Drops the last value. */
  public void pop_back() {
    if (isEmpty()) {
      throw new NoSuchElementException("pop_back of an empty list");
    }
    remove(size() - 1);
  }

  /** The first value. */
  public UValue front() {
    return getFirst();
  }

  /** The values as instances of a type, see {@link UValue#as(Class)}. */
  public <T> List<T> as(Class<T> type) {
    List<T> result = new ArrayList<>(size());
    for (UValue value : array) {
      result.add(value.as(type));
    }
    return result;
  }

  /** The list as an urbiscript literal. */
  @Override
  public String toString() {
    return UValueWriter.text(new UValue(this));
  }
}
