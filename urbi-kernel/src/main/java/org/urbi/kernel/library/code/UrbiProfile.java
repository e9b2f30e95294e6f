package org.urbi.kernel.library.code;

import org.urbi.kernel.node.Profiler;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** What code has called, and for how long (manual, "Profile"). */
public final class UrbiProfile extends UrbiObject {
  private final Profiler profiler;

  public UrbiProfile(Shape shape, Profiler profiler) {
    super(shape);
    this.profiler = profiler;
  }

  /** Null in the prototype. */
  Profiler profiler() {
    return profiler;
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiProfile(cloneShape(), profiler);
  }
}
