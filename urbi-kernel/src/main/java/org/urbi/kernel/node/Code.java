package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiCode;
import org.urbi.kernel.object.UrbiObject;

/** What can be called: functions written in urbiscript, and primitives written in Java. */
public abstract class Code extends UrbiCode {
  protected Code(Shape shape) {
    super(shape);
  }

  /** The name under which Java code declares it; null for a function written in urbiscript. */
  public @Nullable String name() {
    return null;
  }

  /** Whether it wants its arguments unevaluated, in a call message. */
  public abstract boolean isLazy();

  /**
   * Calls it.
   *
   * @param caller the activation from which it is called
   * @param site the place, for backtraces and for {@code call}
   * @param self the target
   * @param arguments already evaluated; a lazy function finds them in its call message
   */
  public abstract UrbiObject call(
      Frame caller, CallSite site, UrbiObject self, UrbiObject... arguments);
}
