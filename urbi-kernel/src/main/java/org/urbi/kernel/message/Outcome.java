package org.urbi.kernel.message;

import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;

/**
 * The outcome of work done outside the kernel thread. A live object that the work has got, such as
 * an open file, stays with whoever waits for it.
 */
public sealed interface Outcome {
  /** The work was done, with that result. */
  record Value(Data data) implements Outcome {}

  /** The work has failed; a replay is told the kind of failure and its text. */
  record Failure(Throwable thrown) implements Outcome {}

  /** Work that can fail. */
  @FunctionalInterface
  interface Work<T> {
    @Nullable T run() throws Exception;
  }

  /** That result. */
  static Outcome value(@Nullable Object value) {
    return new Value(new Data(value));
  }

  /** Does some work, and keeps its outcome; a result that is no data is a failure. */
  static Outcome of(Work<?> work) {
    try {
      return value(work.run());
    } catch (Throwable e) {
      return new Failure(e);
    }
  }

  /**
   * Does some work at once.
   *
   * @throws IOException as {@link #get} does
   */
  static <T> @Nullable T now(Work<T> work) throws IOException {
    try {
      return work.run();
    } catch (Throwable e) {
      throw thrown(e);
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
  default <T> @Nullable T get() throws IOException {
    return switch (this) {
      case Value value -> (T) value.data().value();
      case Failure failure -> throw thrown(failure.thrown());
    };
  }

  private static IOException thrown(Throwable failure) {
    return switch (failure) {
      case IOException e -> e;
      case RuntimeException e -> throw e;
      case OutOfMemoryError e -> new IOException(Problem.MEMORY_EXHAUSTED.text(), e);
      case Error e -> throw e;
      default -> new IOException(failure);
    };
  }
}
