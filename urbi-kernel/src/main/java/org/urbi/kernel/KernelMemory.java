package org.urbi.kernel;

import static java.util.Objects.requireNonNull;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.UsageMeter;
import org.urbi.kernel.log.KernelLog;
import org.urbi.kernel.memory.Evictable;
import org.urbi.kernel.memory.LobbyGrowth;
import org.urbi.kernel.memory.MemoryUser;
import org.urbi.kernel.time.SystemClock;

/** What a kernel does when the memory of its process runs out: its lobbies give back theirs. */
final class KernelMemory implements MemoryUser {
  private final Set<Evictable> candidates = ConcurrentHashMap.newKeySet();
  private final LobbyGrowth growth;
  private final KernelLog log;
  private final Consumer<Boolean> onNearlyFull;
  private final Runnable onExhausted;
  private final LongSupplier turns;
  private final Predicate<Budget> isTurnOf;
  private final Runnable watched;

  /** Whose jobs were ended, and who can be let go next. */
  private final Queue<Evictable> evicted = new ArrayDeque<>();

  /** Who was asked last: to end its jobs, or to go. */
  private @Nullable Evictable asked;

  private boolean askedToGo;

  /** The turn in which the kernel was when somebody was last asked to give back memory. */
  private long turnBefore = -1;

  /**
   * @param turns the number of the current turn, on any thread
   * @param isTurnOf whether a job with that budget is running, on any thread
   * @param watched called in each look
   * @param onNearlyFull told when memory is nearly exhausted, and when it is not any more
   * @param onExhausted called when memory could not be freed
   */
  KernelMemory(
      UsageMeter meter,
      LongSupplier turns,
      Predicate<Budget> isTurnOf,
      KernelLog log,
      Runnable watched,
      Consumer<Boolean> onNearlyFull,
      Runnable onExhausted) {
    this.turns = turns;
    this.isTurnOf = isTurnOf;
    this.growth =
        new LobbyGrowth(
            budget -> {
              meter.begin();
              return meter.bytes(budget);
            },
            candidates,
            new SystemClock()::now);
    this.log = log;
    this.watched = watched;
    this.onNearlyFull = onNearlyFull;
    this.onExhausted = onExhausted;
  }

  void add(Evictable candidate) {
    candidates.add(candidate);
  }

  void remove(Evictable candidate) {
    candidates.remove(candidate);
  }

  @Override
  public void prepare() {
    // The first stack trace initializes classes of the JDK; where that fails, none is ever told.
    requireNonNull(new Throwable().getStackTrace());
  }

  @Override
  public void memoryScarce(boolean scarce) {
    watched.run();
    growth.measure(scarce);
    if (!scarce) {
      growth.forget();
      evicted.clear();
      asked = null;
    }
  }

  @Override
  public double growth() {
    return holder() != null || remaining() != null ? Double.POSITIVE_INFINITY : growth.largest();
  }

  /**
   * Ends the jobs of the lobby that has grown most, and tells its client. If that was not enough,
   * the next call disconnects that client, which frees the lobby's objects; the one after that
   * turns to the next lobby. But whoever holds the kernel keeps those who were ended from ending,
   * so it goes first.
   */
  @Override
  public void relieve() {
    Evictable holder = holder();
    turnBefore = turns.getAsLong();
    if (holder != null) {
      evict(holder);
      return;
    }
    Evictable before = remaining();
    if (before != null) {
      // There may be no memory even for this: then it is tried again. It is told first, because
      // who has been closed is not found again.
      tell(Problem.LETTING_GO, before);
      try {
        before.close();
      } catch (RuntimeException e) {
        // This is a bug, and would be met again: the next client is asked instead. A lack of memory
        // passes, so it is not caught here.
        evicted.remove(before);
        throw e;
      }
      evicted.remove(before);
      growth.evicted(before);
      asked = before;
      askedToGo = true;
      return;
    }
    Evictable next = growth.next();
    if (next != null) {
      evict(next);
    }
  }

  private void evict(Evictable next) {
    tell(Problem.EVICTING, next);
    try {
      next.evict(Problem.MEMORY_EXHAUSTED.text());
    } catch (RuntimeException e) {
      growth.evicted(next);
      throw e;
    }
    growth.evicted(next);
    evicted.add(next);
    asked = next;
    askedToGo = false;
  }

  @Override
  public boolean isDone() {
    Evictable last = asked;
    boolean done = last != null && !(askedToGo ? candidates.contains(last) : last.isAtWork());
    if (done) {
      // It would keep the memory of who is gone.
      asked = null;
    }
    return done;
  }

  /** Whoever has held the kernel since somebody was last asked to give back memory. */
  private @Nullable Evictable holder() {
    if (turnBefore != turns.getAsLong()) {
      return null;
    }
    for (Evictable each : candidates) {
      Budget budget = each.budget();
      if (budget != null && isTurnOf.test(budget) && growth.mayBeAsked(each)) {
        return each;
      }
    }
    return null;
  }

  /** Whose jobs were ended before, if it can be let go now. */
  private @Nullable Evictable remaining() {
    for (Evictable each : evicted) {
      if (candidates.contains(each) && !each.stays()) {
        return each;
      }
    }
    return null;
  }

  @Override
  public void memoryNearlyFull(boolean full) {
    onNearlyFull.accept(full);
  }

  @Override
  public void memoryExhausted() {
    onExhausted.run();
  }

  private void tell(Problem done, Evictable whom) {
    log.write(Problem.MEMORY_NEARLY_EXHAUSTED.text(done.text(whom.description())));
  }
}
