package org.urbi.kernel.library.concurrent;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.event.Emission;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** An emission that lasts, as urbiscript sees it. */
final class UrbiEmission extends UrbiObject {
  private final @Nullable Emission emission;

  UrbiEmission(Shape shape, @Nullable Emission emission) {
    super(shape);
    this.emission = emission;
  }

  /** The emission; null in the prototype. */
  @Nullable Emission emission() {
    return emission;
  }
}
