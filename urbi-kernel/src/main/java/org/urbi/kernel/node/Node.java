package org.urbi.kernel.node;

import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** A piece of code, ready to be executed. */
public abstract class Node {
  private final Span span;

  protected Node(Span span) {
    this.span = span;
  }

  /** Where it was written. */
  public final Span span() {
    return span;
  }

  /** Executes the code and returns its value, which may be void. */
  public abstract UrbiObject execute(Frame frame);

  /** Executes the code as a condition. */
  public boolean test(Frame frame) {
    return Truth.of(frame, execute(frame));
  }
}
