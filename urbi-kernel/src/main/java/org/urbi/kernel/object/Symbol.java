package org.urbi.kernel.object;

/**
 * The name of a slot, interned per kernel, so that names compare by identity.
 *
 * <p>Its epoch counts the changes after which a remembered lookup of this name may no longer hold:
 * each time a slot of this name appears in, or vanishes from, an object that others inherit from.
 */
public final class Symbol {
  private final String name;
  int epoch;

  Symbol(String name) {
    this.name = name;
  }

  public String name() {
    return name;
  }

  /**
   * Changes whenever a lookup of this name that was {@linkplain World#remember remembered} must be
   * made again.
   */
  public int epoch() {
    return epoch;
  }

  @Override
  public String toString() {
    return name;
  }
}
