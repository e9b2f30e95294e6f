package org.urbi.kernel.event;

import org.urbi.kernel.node.Node;

/** The condition of {@code at}, {@code whenever} or {@code waituntil}. */
public sealed interface Condition {
  /** Waits for an expression to be true. */
  record WhenTrue(Node expression) implements Condition {}

  /** Waits for an event that the filter accepts. */
  record WhenEmitted(Node event, EventFilter filter) implements Condition {}
}
