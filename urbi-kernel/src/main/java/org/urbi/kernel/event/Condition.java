package org.urbi.kernel.event;

import org.urbi.kernel.node.Node;

/** What code waits for. */
public sealed interface Condition {
  /** For an expression to be true. */
  record Holds(Node expression) implements Condition {}

  /** For an event that the filter accepts. */
  record Emitted(Node event, EventFilter filter) implements Condition {}
}
