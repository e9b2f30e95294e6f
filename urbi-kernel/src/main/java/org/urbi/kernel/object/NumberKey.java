package org.urbi.kernel.object;

/** A number as key, which has an order as the other numbers. */
record NumberKey(double number, UrbiObject value)
    implements UrbiDictionary.Key, Comparable<NumberKey> {
  /**
   * Carries what is in the highest bits of a hash code to all others. Whole numbers differ in the
   * highest bits of a double alone, of which a table of a few thousand entries uses hardly any.
   */
  private static final int SPREAD = 0x9E3779B9;

  /** The hash code of a number, the same for both zeros. */
  static int hash(double number) {
    return Double.hashCode(number + 0.0) * SPREAD;
  }

  @Override
  public int compareTo(NumberKey other) {
    return Double.compare(number + 0.0, other.number + 0.0);
  }

  @Override
  public Comparable<?> rank() {
    return number;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof NumberKey key && number == key.number;
  }

  @Override
  public int hashCode() {
    // What is not a number equals nothing, not even itself: it is found nowhere.
    return Double.isNaN(number) ? System.identityHashCode(value) : hash(number);
  }
}
