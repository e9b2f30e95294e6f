package org.urbi.kernel.object;

/**
 * The name of a slot, interned per kernel, so that names compare by identity.
 *
 * <p>Its epoch counts the changes that may invalidate cached lookups of this name: each slot of
 * this name that is added to, or removed from, an object that others inherit from.
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

  /** Whether that is a name as one writes it; not an operator, nor empty. */
  public static boolean isWord(String name) {
    return !name.isEmpty() && Character.isJavaIdentifierStart(name.charAt(0));
  }

  /**
   * Changes whenever lookups of this name that were {@linkplain World#remember remembered} become
   * invalid.
   */
  public int epoch() {
    return epoch;
  }

  @Override
  public String toString() {
    return name;
  }
}
