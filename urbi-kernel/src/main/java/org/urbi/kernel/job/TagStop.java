package org.urbi.kernel.job;

import org.urbi.kernel.object.UrbiObject;

/** Unwinds a job up to the tagged code that was stopped (manual, "Tag", {@code stop}). */
public final class TagStop extends Unwinding {
  private final transient TagScope scope;
  private final transient UrbiObject value;
  private final boolean interruption;

  TagStop(TagScope scope, UrbiObject value) {
    this(scope, value, false);
  }

  private TagStop(TagScope scope, UrbiObject value, boolean interruption) {
    this.scope = scope;
    this.value = value;
    this.interruption = interruption;
  }

  /** Ends what a job is doing, because somebody has interrupted it. */
  static TagStop interruption() {
    return new TagStop(null, null, true);
  }

  /** Whether the job was interrupted in code that did not let others run. */
  public boolean isInterruption() {
    return interruption;
  }

  /** The execution of tagged code that ends; null when the whole job does. */
  public TagScope scope() {
    return scope;
  }

  /** What the tagged code returns. */
  public UrbiObject value() {
    return value;
  }
}
