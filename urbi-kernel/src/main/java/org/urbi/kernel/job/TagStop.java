package org.urbi.kernel.job;

import org.urbi.kernel.object.UrbiObject;

/** Unwinds a job up to the tagged code that was stopped (manual, "Tag", {@code stop}). */
public final class TagStop extends Unwinding {
  private final transient TagScope scope;
  private final transient UrbiObject value;

  TagStop(TagScope scope, UrbiObject value) {
    this.scope = scope;
    this.value = value;
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
