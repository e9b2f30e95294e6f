package org.urbi.kernel.event;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Pattern;
import org.urbi.kernel.object.UrbiObject;

/** Decides which emissions match: {@code event?(patterns) if guard}. */
public final class EventFilter {
  private final Pattern @Nullable [] patterns;
  private final @Nullable Node guard;

  /**
   * @param patterns null for any payload
   * @param guard may be null
   */
  public EventFilter(Pattern @Nullable [] patterns, @Nullable Node guard) {
    this.patterns = patterns;
    this.guard = guard;
  }

  /** Whether every emission matches, without evaluating any code. */
  boolean acceptsAll() {
    return patterns == null && guard == null;
  }

  /** Whether a payload matches; binds the variables of the patterns. */
  boolean accepts(Frame frame, UrbiObject[] payload) {
    if (patterns != null) {
      if (patterns.length != payload.length) {
        return false;
      }
      for (int i = 0; i < patterns.length; i++) {
        if (!patterns[i].matches(frame, payload[i])) {
          return false;
        }
      }
    }
    return guard == null || guard.test(frame);
  }
}
