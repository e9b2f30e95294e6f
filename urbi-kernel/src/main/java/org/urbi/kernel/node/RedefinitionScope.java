package org.urbi.kernel.node;

import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/**
 * A scope whose code may ask for {@code redefinitionMode} or {@code nonInterruptible}, which end
 * with the scope (manual, "System").
 */
public final class RedefinitionScope extends Node {
  private final Node body;

  public RedefinitionScope(Span span, Node body) {
    super(span);
    this.body = body;
  }

  @Override
  public UrbiObject execute(Frame frame) {
    int before = frame.job.redefinitions();
    int held = frame.job.nonInterruptible();
    try {
      return body.execute(frame);
    } finally {
      frame.job.endRedefinitions(before);
      frame.job.endNonInterruptible(held);
    }
  }
}
