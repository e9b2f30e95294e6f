package org.urbi.kernel.object;

import org.jspecify.annotations.Nullable;

/**
 * The names of the slots that all objects of a kind have from the start, in their order. The shape
 * of such objects is looked up once for each prototype, not once for each object.
 */
public final class SlotNames {
  private final Symbol[] names;
  private @Nullable Shape empty;
  private @Nullable Shape filled;

  public SlotNames(Symbol... names) {
    this.names = names;
  }

  /** That shape, which has no slots, with these. */
  Shape in(Shape other) {
    Shape known = filled;
    if (known == null || other != empty) {
      known = other;
      for (Symbol name : names) {
        known = known.with(name);
      }
      empty = other;
      filled = known;
    }
    return known;
  }
}
