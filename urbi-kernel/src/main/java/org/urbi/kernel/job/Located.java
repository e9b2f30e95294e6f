package org.urbi.kernel.job;

import org.jspecify.annotations.Nullable;
import org.urbi.lang.source.Span;

/** What was written somewhere. */
@FunctionalInterface
public interface Located {
  /** Where it was written; null when nobody knows. */
  @Nullable Span span();
}
