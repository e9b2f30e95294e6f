package org.urbi.kernel.message;

import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;

/**
 * The outcome of work done outside the kernel thread: its result or its failure.
 *
 * @param value the result, if there is no failure: a value that the journal can write, or a live
 *     object (an open file, say), which a replay does not have
 * @param failure what was thrown, or null
 */
public record Outcome(@Nullable Object value, @Nullable Throwable failure) {
  /** Work that can fail. */
  @FunctionalInterface
  public interface Work<T> {
    @Nullable T run() throws Exception;
  }

  /** Does some work, and keeps its outcome. */
  public static Outcome of(Work<?> work) {
    try {
      return new Outcome(work.run(), null);
    } catch (Throwable e) {
      return new Outcome(null, e);
    }
  }

  /**
   * The result.
   *
   * @throws IOException if the work threw one, or a checked exception or error that is wrapped in
   *     one: memory that was not enough for the work must not end anything else
   */
  // Who asks knows what the work was.
  @SuppressWarnings("unchecked")
  public <T> @Nullable T get() throws IOException {
    if (failure == null) {
      return (T) value;
    }
    if (failure instanceof IOException e) {
      throw e;
    }
    if (failure instanceof RuntimeException e) {
      throw e;
    }
    if (failure instanceof OutOfMemoryError) {
      throw new IOException(Problem.MEMORY_EXHAUSTED.text(), failure);
    }
    if (failure instanceof Error e) {
      throw e;
    }
    throw new IOException(failure);
  }
}
