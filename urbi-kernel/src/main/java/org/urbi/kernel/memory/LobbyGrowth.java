package org.urbi.kernel.memory;

import java.util.Collection;
import java.util.Map;
import java.util.WeakHashMap;
import java.util.function.LongSupplier;
import java.util.function.ToLongFunction;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;

/**
 * Finds the lobby that has grown most lately: the one whose jobs have allocated most, where recent
 * allocations weigh more. Memory that has become garbage since counts, too, because nobody knows
 * whose it was.
 */
public final class LobbyGrowth {
  /** The factor by which older allocations lose weight at each measurement. */
  private static final double KEPT = 0.98;

  /** While memory is not scarce, only one of so many measurements is made. */
  private static final int SELDOM = 20;

  private static final double KEPT_SELDOM = Math.pow(KEPT, SELDOM);

  /** Who has less than this share of all growth has nothing worth giving back. */
  private static final double NEGLIGIBLE = 0.005;

  /**
   * Who has less than this share of the growth of the largest one that was asked is spared for some
   * time ({@link #PATIENCE}).
   */
  private static final double LITTLE = 0.05;

  /**
   * For how many nanoseconds somebody small is spared after a large one was asked: until what that
   * one had can be collected, and less long than those who free memory wait before they give up.
   */
  private static final long PATIENCE = 3_000_000_000L;

  private final ToLongFunction<Budget> allocated;
  private final Collection<Evictable> candidates;
  private final LongSupplier now;
  private final Map<Evictable, Score> scores = new WeakHashMap<>();

  /** The growth of all of them, including those that have gone. */
  private double all;

  /** The largest growth of those that have been asked, and when the last one was. */
  private double largestAsked;

  private long askedAt;

  private int skipped;

  private static final class Score {
    long bytes;
    double grown;
    boolean evicted;
  }

  /**
   * @param allocated how many bytes jobs with that budget have allocated so far
   * @param candidates all there are, at any time
   * @param now real time, in nanoseconds
   */
  public LobbyGrowth(
      ToLongFunction<Budget> allocated, Collection<Evictable> candidates, LongSupplier now) {
    this.allocated = allocated;
    this.candidates = candidates;
    this.now = now;
  }

  /**
   * Measures how much each has grown; to be called several times a second. What was allocated at
   * one go just before memory became scarce must be known by then, so it is always measured.
   */
  public synchronized void measure(boolean scarce) {
    if (scarce) {
      measure(KEPT);
    } else if (skipped++ % SELDOM == 0) {
      measure(KEPT_SELDOM);
    }
  }

  private void measure(double kept) {
    all *= kept;
    for (Evictable each : candidates) {
      Budget budget = each.budget();
      if (budget != null) {
        long bytes = allocated.applyAsLong(budget);
        Score score = scores.computeIfAbsent(each, unknown -> new Score());
        score.grown = score.grown * kept + bytes - score.bytes;
        all += bytes - score.bytes;
        score.bytes = bytes;
      }
    }
  }

  /** That one has been asked to give back its memory, so others are next. */
  public synchronized void evicted(Evictable asked) {
    Score score = scores.get(asked);
    if (score != null) {
      score.evicted = true;
      largestAsked = Math.max(largestAsked, score.grown);
      askedAt = now.getAsLong();
    }
  }

  /** Whether that one has not been asked yet, and is not spared. */
  public synchronized boolean mayBeAsked(Evictable one) {
    Score score = scores.get(one);
    return score != null && !score.evicted && score.grown >= leastAsked();
  }

  /** How much a lobby must have grown to be asked: far less than the last one is spared. */
  private double leastAsked() {
    return now.getAsLong() - askedAt < PATIENCE ? LITTLE * largestAsked : 0;
  }

  /** Whoever has been asked before may be asked again. */
  public synchronized void forget() {
    scores.values().forEach(score -> score.evicted = false);
    largestAsked = 0;
  }

  /** How much the {@link #next} one has grown, in bytes; 0 if there is none. */
  public synchronized double largest() {
    Map.Entry<Evictable, Score> most = most();
    return most == null ? 0 : most.getValue().grown;
  }

  /** The one whose lobby has grown most, of those not asked yet; null when none has grown. */
  public synchronized @Nullable Evictable next() {
    Map.Entry<Evictable, Score> most = most();
    return most == null ? null : most.getKey();
  }

  private Map.@Nullable Entry<Evictable, Score> most() {
    Map.Entry<Evictable, Score> most = null;
    double grown = Math.max(NEGLIGIBLE * all, leastAsked());
    for (Evictable each : candidates) {
      Score score = scores.get(each);
      if (score != null && !score.evicted && score.grown > grown) {
        most = Map.entry(each, score);
        grown = score.grown;
      }
    }
    return most;
  }
}
