package org.urbi.kernel.compile;

import org.urbi.lang.ast.Declaring;

/** A local variable, identified by its declaration. */
final class LocalVariable {
  private final CompilationUnit unit;
  private final int region;
  private final Declaring key;
  private final boolean shared;
  private final int index;

  /**
   * @param key the declaration in the tree
   * @param shared whether it is kept in a cell
   */
  LocalVariable(CompilationUnit unit, int region, Declaring key, boolean shared, int index) {
    this.unit = unit;
    this.region = region;
    this.key = key;
    this.shared = shared;
    this.index = index;
  }

  CompilationUnit unit() {
    return unit;
  }

  int region() {
    return region;
  }

  Declaring key() {
    return key;
  }

  boolean shared() {
    return shared;
  }

  int index() {
    return index;
  }
}
