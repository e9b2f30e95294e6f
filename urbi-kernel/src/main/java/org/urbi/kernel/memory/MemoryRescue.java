package org.urbi.kernel.memory;

import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.outside.Heap;
import org.urbi.kernel.time.Clock;

/**
 * Frees memory when it is nearly exhausted: ends what the lobby does that has grown most, of all
 * kernels of the process, then the next one, and gives up if that does not help.
 */
final class MemoryRescue {
  /** How long ended jobs have to free their memory, in nanoseconds. */
  private static final long RELIEF = 4_000_000_000L;

  /** The time between two measurements of who grows, in nanoseconds. */
  private static final long MEASURING = 200_000_000;

  /**
   * The time until the next lobby is ended, in nanoseconds, if the one before does not end sooner.
   */
  private static final long NEXT_RELIEF = 1_000_000_000;

  /** The time until the next lobby is ended when so little is left that nobody could go on. */
  private static final long URGENT_RELIEF = 100_000_000;

  /** How long freeing memory may take in all, in nanoseconds. */
  private static final long MAX_RELIEF = 20_000_000_000L;

  /** How long nothing is tried after giving up, in nanoseconds. */
  private static final long REST = 10_000_000_000L;

  // Made beforehand: when they are needed, there may be no memory to make them with.
  private static final Consumer<MemoryUser> SCARCE = user -> user.memoryScarce(true);
  private static final Consumer<MemoryUser> NOT_SCARCE = user -> user.memoryScarce(false);
  private static final Consumer<MemoryUser> FULL = user -> user.memoryNearlyFull(true);
  private static final Consumer<MemoryUser> NOT_FULL = user -> user.memoryNearlyFull(false);
  private static final Consumer<MemoryUser> EXHAUSTED = MemoryUser::memoryExhausted;

  private final Clock clock;
  private final LongSupplier worked;
  private final Heap heap;
  private final Consumer<RuntimeException> log;
  private boolean told;
  private boolean began;
  private long since;

  /** When that seemed to have succeeded. */
  private long until;

  private boolean relieved;
  private long relievedAt;

  /** Who was asked to free memory, and has not been seen to have done it; null if nobody. */
  private @Nullable MemoryUser asked;

  private boolean measured;
  private long measuredAt;
  private long collections;

  /** Whether garbage has been collected since the look before, so that nobody needs to do it. */
  private boolean collected;

  private boolean gaveUp;
  private long gaveUpAt;

  /**
   * @param clock real time
   * @param worked for how long the process has worked, by which it is given time to free memory
   * @param log is told of a defect of one of the users, which the others must not suffer from
   */
  MemoryRescue(Clock clock, LongSupplier worked, Heap heap, Consumer<RuntimeException> log) {
    this.clock = clock;
    this.worked = worked;
    this.heap = heap;
    this.log = log;
  }

  /** To be called several times a second. */
  void check(MemoryUser[] users) {
    boolean scarce = heap.isScarce();
    long now = clock.now();
    if (!scarce || !measured || now - measuredAt >= MEASURING) {
      measured = scarce;
      measuredAt = now;
      each(users, scarce ? SCARCE : NOT_SCARCE);
    }
    if (!scarce) {
      until = since;
      heap.forget();
      heap.keepReserve();
    }
    if (scarce && heap.isNearlyFull(now)) {
      rescue(users);
    } else if (told) {
      until = scarce ? worked.getAsLong() : since;
      told = false;
      began = false;
      asked = null;
      gaveUp = false;
      each(users, NOT_FULL);
    }
  }

  /**
   * Whether somebody has been asked to free memory and has not done it yet: then it is to be
   * checked often, because the next one is asked as soon as that has not been enough.
   */
  boolean isWaiting() {
    return asked != null;
  }

  /** What is alive is to be known before the rest of the memory is filled. */
  void collect() {
    heap.collect();
  }

  /**
   * To be called when memory is nearly exhausted, or was when somebody wanted to look. It takes
   * some memory to free more: a little was kept for that.
   */
  void rescue(MemoryUser[] users) {
    rescue(users, false);
  }

  /**
   * To be called when there was no memory for something, and all garbage has been collected for it.
   * If that has left much, too much was wanted, which is for those to bear who wanted it.
   */
  void failed(MemoryUser[] users) {
    if (heap.isExhausted()) {
      rescue(users, true);
    }
  }

  private void rescue(MemoryUser[] users, boolean urgent) {
    try {
      attempt(users, urgent);
    } catch (Error e) {
      heap.releaseReserve();
      attemptAgain(users, urgent);
    }
  }

  private void attemptAgain(MemoryUser[] users, boolean urgent) {
    try {
      attempt(users, urgent);
    } catch (Error e) {
      // There was no memory for it: it is tried again, as long as there is hope.
      long now = worked.getAsLong();
      if (!began) {
        begin(now);
      } else if (isOver(now)) {
        giveUp(users);
      }
    }
  }

  private void attempt(MemoryUser[] users, boolean urgent) {
    if (urgent) {
      // Who has grown is asked for below; nobody may have looked since memory became scarce.
      each(users, SCARCE);
    }
    long now = worked.getAsLong();
    long before = collections;
    collections = heap.collections();
    collected = collections != before;
    if (gaveUp && now - gaveUpAt < REST) {
      return;
    }
    if (!began) {
      begin(now);
      each(users, FULL);
    }
    boolean done = isDone();
    if (isOver(now)) {
      if (urgent || !isRelieved()) {
        giveUp(users);
      }
    } else if (!relieved
        || done && !isRelieved()
        || now - relievedAt >= (urgent ? URGENT_RELIEF : NEXT_RELIEF)
            && (urgent || !isRelieved())) {
      relieve(users);
    }
  }

  private void begin(long now) {
    began = true;
    told = true;
    since = now - leftFromBefore(now);
    relievedAt = now;
    relieved = false;
    asked = null;
  }

  /**
   * How long freeing memory has taken before, less than what has passed since: a moment with some
   * room, which is filled at once, is no success.
   */
  private long leftFromBefore(long now) {
    return Math.max(0, until - since - (now - until));
  }

  private boolean isOver(long now) {
    return now - relievedAt > RELIEF || now - since > MAX_RELIEF;
  }

  /** Whether who was asked to free memory has just done it: what that was is garbage now. */
  private boolean isDone() {
    MemoryUser last = asked;
    boolean done = false;
    if (last != null) {
      try {
        done = last.isDone();
      } catch (RuntimeException e) {
        asked = null;
        log.accept(e);
      }
    }
    if (done) {
      asked = null;
      collected = false;
    }
    return done;
  }

  /** Whether there is room again: what was ended may have become garbage, or what has left. */
  private boolean isRelieved() {
    if (!collected) {
      heap.collect();
    }
    return !(heap.isScarce() && heap.isNearlyFull(clock.now()));
  }

  private void relieve(MemoryUser[] users) {
    heap.expectRelief();
    @Nullable MemoryUser most = null;
    double grown = 0;
    for (MemoryUser each : users) {
      double growth = growthOf(each);
      if (growth > grown) {
        most = each;
        grown = growth;
      }
    }
    if (most != null) {
      // To ask somebody takes some memory, and so does ending what is done.
      heap.releaseReserve();
      try {
        most.relieve();
      } catch (RuntimeException e) {
        log.accept(e);
      }
      asked = most;
      relieved = true;
      relievedAt = worked.getAsLong();
    }
  }

  /** Who cannot say it is not asked for anything. */
  private double growthOf(MemoryUser user) {
    try {
      return user.growth();
    } catch (RuntimeException e) {
      log.accept(e);
      return 0;
    }
  }

  private void giveUp(MemoryUser[] users) {
    began = false;
    asked = null;
    gaveUp = true;
    gaveUpAt = worked.getAsLong();
    until = since;
    try {
      // Whoever was ended before and fills the memory again is to be ended again.
      each(users, NOT_SCARCE);
    } catch (Error e) {
      // There is no memory for that either.
    }
    each(users, EXHAUSTED);
  }

  /** Tells all of them, even if one fails. */
  private void each(MemoryUser[] users, Consumer<MemoryUser> what) {
    Error fatal = null;
    for (MemoryUser user : users) {
      try {
        what.accept(user);
      } catch (RuntimeException e) {
        log.accept(e);
      } catch (Error e) {
        fatal = e;
      }
    }
    if (fatal != null) {
      throw fatal;
    }
  }
}
