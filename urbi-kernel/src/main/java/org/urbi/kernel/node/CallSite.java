package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.lang.source.Span;

/** A place in the code from which something is called. */
public interface CallSite {
  /** No arguments. */
  Node[] NO_CODE = {};

  /** The name in the backtrace. */
  String calledName();

  /** The place in the backtrace; null when there is none. */
  @Nullable Span calledSpan();

  /** Whether backtraces show it. */
  default boolean isTraced() {
    return true;
  }

  /** Whether a name was called; Java code also calls function values. */
  default boolean isNamed() {
    return true;
  }

  /** The arguments, as code; none when they came from Java. */
  default Node[] argumentNodes() {
    return NO_CODE;
  }
}
