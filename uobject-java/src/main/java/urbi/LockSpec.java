package urbi;

import java.util.Objects;

/**
 * A lock mode with a limit (manual, "Asynchronous binding").
 *
 * @param lockMode which calls exclude one another
 * @param maxQueueSize how many of them there may be at a time, the one that runs included; the
 *     others are dropped. 0 for any number.
 */
public record LockSpec(LockMode lockMode, int maxQueueSize) {
  /** One call of a function at a time; what comes meanwhile is dropped. */
  public static final LockSpec LOCK_FUNCTION_DROP = new LockSpec(LockMode.LOCK_FUNCTION, 1);

  /** One call of a function at a time, and one that waits; what comes meanwhile is dropped. */
  public static final LockSpec LOCK_FUNCTION_KEEP_ONE = new LockSpec(LockMode.LOCK_FUNCTION, 2);

  public LockSpec {
    Objects.requireNonNull(lockMode, "lockMode");
    if (maxQueueSize < 0) {
      throw new IllegalArgumentException("negative size of a queue: " + maxQueueSize);
    }
  }

  /** Without a limit. */
  public LockSpec(LockMode lockMode) {
    this(lockMode, 0);
  }
}
