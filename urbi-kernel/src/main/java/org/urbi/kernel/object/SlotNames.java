package org.urbi.kernel.object;

import java.lang.ref.WeakReference;
import org.jspecify.annotations.Nullable;

/**
 * The names of slots that objects get together, in their order. The shape of such objects is looked
 * up once for each shape that they had before, not once for each object.
 */
public final class SlotNames {
  private static final int STEPS = 4;

  /**
   * A shape without these slots, and the same with them. Both are weak references: a shape keeps
   * its prototypes alive, which may be those of a client.
   */
  private record Step(WeakReference<Shape> before, WeakReference<Shape> after) {}

  private final Symbol[] names;
  private @Nullable Shape empty;
  private @Nullable Shape filled;
  private final @Nullable Step[] steps = new Step[STEPS];
  private int newest;

  public SlotNames(Symbol... names) {
    this.names = names;
  }

  /** That shape of new objects, which has no slots, with these. */
  Shape in(Shape other) {
    Shape known = filled;
    if (known == null || other != empty) {
      known = with(other);
      empty = other;
      filled = known;
    }
    return known;
  }

  private Shape with(Shape other) {
    Shape more = other;
    for (Symbol name : names) {
      more = more.with(name);
    }
    return more;
  }

  /** Gives an object these slots, at its end, in place of those of that name that it has. */
  public void put(UrbiObject object, UrbiObject... values) {
    Shape next = known(object.shape);
    if (next == null) {
      for (Symbol name : names) {
        object.removeSlot(name);
      }
      Shape before = object.shape;
      next = with(before);
      if (next != before) { // not an object with a table of slots
        newest = (newest + 1) % STEPS;
        steps[newest] = new Step(new WeakReference<>(before), new WeakReference<>(next));
      }
    }
    object.append(next, names, values);
  }

  /** What a shape that has none of these slots was followed by; null if that is not known. */
  private @Nullable Shape known(Shape before) {
    for (Step step : steps) {
      if (step != null && step.before.refersTo(before)) {
        return step.after.get();
      }
    }
    return null;
  }
}
