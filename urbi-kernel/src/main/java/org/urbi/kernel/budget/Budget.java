package org.urbi.kernel.budget;

import java.util.concurrent.atomic.AtomicLongArray;
import java.util.function.ObjLongConsumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.time.RateLimit;

/**
 * The limits of a lobby, and how much of each resource it uses at present. Code that is about to
 * use a limited resource takes it here first. Used on the kernel thread, except for what is
 * {@linkplain #nanoseconds measured}.
 */
public final class Budget {
  /**
   * Four times the memory of a sleeping job, in bytes: two lobbies that have all the jobs they may
   * fill half of it.
   */
  private static final long MEMORY_OF_JOB = 8192;

  /** There is no limit. */
  public static final long UNLIMITED = Long.MAX_VALUE;

  private static final long NANOSECONDS_PER_MILLISECOND = 1_000_000;

  /**
   * For how many milliseconds a job may hold a kernel that sets no limit when its client has left:
   * there is nobody who could interrupt it.
   */
  private static final long HOLD_WHEN_ABANDONED = 1000;

  private static final Pattern PART =
      Pattern.compile("\\s*([a-z]+)\\s*=\\s*(\\d{1,15})([kMG%]?)\\s*");

  private final AtomicLongArray limits = new AtomicLongArray(Resource.values().length);
  private final AtomicLongArray used = new AtomicLongArray(Resource.values().length);
  private volatile long nanoseconds;
  private volatile long bytes;
  private volatile boolean abandoned;

  private final ObjLongConsumer<Resource> limited;

  /** Where its use counts, too; null at first. */
  private @Nullable Budget common;

  private Runnable whenUseChanges = () -> {};
  private RateLimit log = new RateLimit(UNLIMITED);

  /** A budget without limits. */
  public Budget() {
    this((what, most) -> {});
  }

  /**
   * A budget that has no limits yet.
   *
   * @param limited called with each limit that is set: some resources must then be monitored
   */
  public Budget(ObjLongConsumer<Resource> limited) {
    this.limited = limited;
    for (Resource what : Resource.values()) {
      limits.set(what.ordinal(), UNLIMITED);
    }
  }

  /** The limit of a resource; from any thread. */
  public long limit(Resource what) {
    return limits.get(what.ordinal());
  }

  /** Sets a limit from now on; what is in use already stays. */
  public void setLimit(Resource what, long most) {
    limits.set(what.ordinal(), most);
    if (most != UNLIMITED) {
      limited.accept(what, most);
    }
  }

  /**
   * Sets limits as options say them: {@code jobs=100,output=1M,time=20%}.
   *
   * @throws IllegalArgumentException if they make no sense
   */
  public void setLimits(String text) {
    if (text.isBlank()) {
      return;
    }
    for (String part : text.split(",", -1)) {
      Matcher matcher = PART.matcher(part);
      if (!matcher.matches()) {
        throw new IllegalArgumentException(Problem.NO_BUDGET.text(part.strip()));
      }
      long unit =
          switch (matcher.group(3)) {
            case "k" -> 1L << 10;
            case "M" -> 1L << 20;
            case "G" -> 1L << 30;
            default -> 1;
          };
      setLimit(Resource.of(matcher.group(1)), Long.parseLong(matcher.group(2)) * unit);
    }
  }

  /**
   * Adds to the limits given by options those that follow from the size of the memory: only so many
   * jobs that the garbage collector can keep up.
   */
  public static String fitting(long memory, String options) {
    String jobs = Resource.JOBS.word() + "=" + memory / MEMORY_OF_JOB;
    return options.isBlank() ? jobs : jobs + "," + options;
  }

  /**
   * Its client leaves; from any thread. From now on none of its jobs may hold the kernel for ever.
   * That is no limit that programs see or change: what has been left could lift it.
   */
  public void abandon() {
    abandoned = true;
    limited.accept(Resource.HOLD, HOLD_WHEN_ABANDONED);
  }

  /**
   * For how long a job may hold the kernel, in nanoseconds.
   *
   * @param most the limit of all jobs, {@link #UNLIMITED} for none
   */
  public long holdLimit(long most) {
    long own = limit(Resource.HOLD);
    if (abandoned && most == UNLIMITED) {
      own = Math.min(own, HOLD_WHEN_ABANDONED);
    }
    return own > most / NANOSECONDS_PER_MILLISECOND ? most : own * NANOSECONDS_PER_MILLISECOND;
  }

  /** How much is in use; from any thread. */
  public long used(Resource what) {
    return used.getOpaque(what.ordinal());
  }

  /**
   * Takes one unit of a resource. Returns false, and takes nothing, if that would exceed the limit.
   */
  public boolean take(Resource what) {
    if (!allows(what, used.getPlain(what.ordinal()) + 1)) {
      return false;
    }
    change(what, 1);
    return true;
  }

  /** Returns one unit of a resource. */
  public void giveBack(Resource what) {
    change(what, -1);
  }

  private void change(Resource what, int units) {
    int index = what.ordinal();
    used.setOpaque(index, used.getPlain(index) + units);
    if (common != null) {
      common.change(what, units);
    }
    whenUseChanges.run();
  }

  /** Sets an action that runs whenever something is taken or returned. */
  public void whenUseChanges(Runnable action) {
    whenUseChanges = action;
  }

  /**
   * From now on what it uses counts for another one, too, and its jobs take turns with all whose
   * use counts there. Its own limits remain.
   */
  public void join(Budget other) {
    common = other;
    for (Resource what : Resource.values()) {
      int index = what.ordinal();
      other.used.setOpaque(index, other.used.getPlain(index) + used(what));
    }
    other.whenUseChanges.run();
  }

  /** Whose turn it is when one of its jobs runs: another one, if it has {@link #join joined} it. */
  public Budget account() {
    return common == null ? this : common;
  }

  /** How many characters its code may put into the log of the kernel; no limit at first. */
  public RateLimit log() {
    return log;
  }

  /** Sets that limit, for each second. */
  public void limitLog(long most) {
    log = new RateLimit(most);
  }

  /** Whether that amount is within the limit. */
  public boolean allows(Resource what, long amount) {
    return amount <= limit(what);
  }

  // ------------------------------------------------------------------ measured now and then

  /** For how long its jobs have run while that was measured; from any thread. */
  public long nanoseconds() {
    return nanoseconds;
  }

  /** How many bytes its jobs have allocated while that was measured; from any thread. */
  public long bytes() {
    return bytes;
  }

  /** Adds running time and allocated bytes of its jobs. Only called on the kernel thread. */
  public void charge(long moreNanoseconds, long moreBytes) {
    nanoseconds = nanoseconds + moreNanoseconds;
    bytes = bytes + moreBytes;
  }
}
