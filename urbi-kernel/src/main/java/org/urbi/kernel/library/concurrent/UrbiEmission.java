package org.urbi.kernel.library.concurrent;

import org.urbi.kernel.event.Emission;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** An emission that lasts, as urbiscript sees it. */
final class UrbiEmission extends UrbiObject {
  private final Emission emission;

  UrbiEmission(Shape shape, Emission emission) {
    super(shape);
    this.emission = emission;
  }

  /** The emission; null in the prototype. */
  Emission emission() {
    return emission;
  }
}
