package org.urbi.kernel.object;

import java.lang.ref.WeakReference;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * The shapes that follow one shape when a slot is added. They are weak references: a shape lives as
 * long as an object, or a place in the code, uses it, so that names used only for a while leave
 * nothing behind.
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
