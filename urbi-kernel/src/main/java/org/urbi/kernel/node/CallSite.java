package org.urbi.kernel.node;

import org.urbi.lang.source.Span;

/** A place in the code from which something is called. */
public interface CallSite {
  /** The name in the backtrace. */
  String calledName();

  /** The place in the backtrace; null when there is none. */
  Span calledSpan();

  /** Whether backtraces tell of it. */
  default boolean isTraced() {
    return true;
  }

  /** The arguments, as code; null when they came from Java. */
  default Node[] argumentNodes() {
    return null;
  }
}
