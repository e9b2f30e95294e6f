package org.urbi.kernel.job;

import static java.util.Objects.requireNonNull;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiObject;

/** Unwinds a job up to the tagged code that was stopped (manual, "Tag", {@code stop}). */
public final class TagStop extends ControlFlowException {
  /** Ends a whole job; one for all of them, of which there may be very many. */
  static final TagStop WHOLE_JOB = new TagStop(null, null);

  private final transient @Nullable TagScope scope;
  private final transient @Nullable UrbiObject value;
  private final boolean interruption;

  TagStop(@Nullable TagScope scope, @Nullable UrbiObject value) {
    this(scope, value, false);
  }

  private TagStop(@Nullable TagScope scope, @Nullable UrbiObject value, boolean interruption) {
    this.scope = scope;
    this.value = value;
    this.interruption = interruption;
  }

  /** Ends the running statement of a job that was interrupted. */
  public static TagStop interruption() {
    return new TagStop(null, null, true);
  }

  /** Whether the job was interrupted in code that did not let others run. */
  public boolean isInterruption() {
    return interruption;
  }

  /** The execution of tagged code that ends; null when the whole job does. */
  public @Nullable TagScope scope() {
    return scope;
  }

  /** Whether it ends more than something else that is to unwind the same job. */
  boolean isOuter(ControlFlowException other) {
    if (scope == null || !(other instanceof TagStop known)) {
      return true;
    }
    return known.scope != null && scope.depth() < known.scope.depth();
  }

  /** The value that the stopped code returns. */
  public UrbiObject value() {
    return requireNonNull(value, "only what ends the whole job has none");
  }
}
