package org.urbi.kernel.message;

import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;

/**
 * What has become of something that was done outside the kernel thread.
 *
 * @param value the result, if there is no failure: what {@link DataForm} can write, or a live thing
 *     that a replay has to do without
 * @param failure what was thrown, or null
 */
public record Outcome(@Nullable Object value, @Nullable Throwable failure) {
  /** Something that can be done. */
  @FunctionalInterface
  public interface Work<T> {
    @Nullable T run() throws Exception;
  }

  /** Does something, and keeps what comes of it. */
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
   * @throws IOException as the work did, or because of what else it threw; memory that was not
   *     enough for the work is no reason for anything else to end
   */
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
