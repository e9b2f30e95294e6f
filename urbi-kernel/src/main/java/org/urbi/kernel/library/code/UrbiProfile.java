package org.urbi.kernel.library.code;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Profiler;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** The calls of profiled code and their times (manual, "Profile"). */
public final class UrbiProfile extends UrbiObject {
  private final @Nullable Profiler profiler;

  public UrbiProfile(Shape shape, @Nullable Profiler profiler) {
    super(shape);
    this.profiler = profiler;
  }

  /** Null in the prototype. */
  @Nullable Profiler profiler() {
    return profiler;
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiProfile(cloneShape(), profiler);
  }
}
