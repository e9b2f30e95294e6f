package org.urbi.kernel.compile;

/** A local variable, known by where it is declared. */
final class Variable {
  private final Unit unit;
  private final int region;
  private final Object key;
  private final boolean shared;
  private final int index;

  /**
   * @param key the declaration in the tree
   * @param shared whether it stands in a cell
   */
  Variable(Unit unit, int region, Object key, boolean shared, int index) {
    this.unit = unit;
    this.region = region;
    this.key = key;
    this.shared = shared;
    this.index = index;
  }

  Unit unit() {
    return unit;
  }

  int region() {
    return region;
  }

  Object key() {
    return key;
  }

  boolean shared() {
    return shared;
  }

  int index() {
    return index;
  }
}
