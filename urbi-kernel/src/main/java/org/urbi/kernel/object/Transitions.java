package org.urbi.kernel.object;

import java.lang.ref.WeakReference;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * The shapes that one shape becomes when a slot is added. They are held weakly: a shape lives as
 * long as some object, or some place in the code, has it, so that names which come and go leave
 * nothing.
 */
final class Transitions {
  private static final int SWEPT_FROM = 16;

  private final Map<Symbol, WeakReference<Shape>> byName = new HashMap<>();
  private int sweptAt = SWEPT_FROM;

  /** The shape with one more slot of that name, or null when there is none. */
  @Nullable Shape get(Symbol name) {
    WeakReference<Shape> known = byName.get(name);
    return known == null ? null : known.get();
  }

  void put(Symbol name, Shape shape) {
    byName.put(name, new WeakReference<>(shape));
    if (byName.size() > sweptAt) {
      byName.values().removeIf(known -> known.refersTo(null));
      sweptAt = Math.max(SWEPT_FROM, 2 * byName.size());
    }
  }
}
