package org.urbi.kernel.memory;

import java.util.Collection;
import java.util.Map;
import java.util.WeakHashMap;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.job.UsageMeter;

/**
 * Finds the lobby that has grown most lately: the one whose jobs have allocated most since memory
 * became scarce, where recent allocations weigh more. Memory that has become garbage since counts,
 * too, because nobody knows whose it was.
 */
public final class LobbyGrowth {
  /** The factor by which older allocations lose weight at each measurement. */
  private static final double KEPT = 0.98;

  private final UsageMeter meter;
  private final Collection<Evictable> candidates;
  private final Map<Evictable, Score> scores = new WeakHashMap<>();

  private static final class Score {
    long bytes;
    double grown;
    boolean evicted;

    /**
     * @param bytes what was allocated before memory became scarce
     */
    Score(long bytes) {
      this.bytes = bytes;
    }
  }

  /**
   * @param candidates all there are, at any time
   */
  public LobbyGrowth(UsageMeter meter, Collection<Evictable> candidates) {
    this.meter = meter;
    this.candidates = candidates;
  }

  /** To be called several times a second while memory is scarce. */
  public synchronized void measure() {
    meter.begin();
    boolean first = scores.isEmpty();
    for (Evictable each : candidates) {
      Budget budget = each.budget();
      if (budget != null) {
        long bytes = meter.bytes(budget);
        Score score = scores.computeIfAbsent(each, unknown -> new Score(first ? bytes : 0));
        score.grown = score.grown * KEPT + bytes - score.bytes;
        score.bytes = bytes;
      }
    }
  }

  /** Memory is not scarce any more. */
  public synchronized void forget() {
    scores.clear();
  }

  /** How much the {@link #next} one has grown, in bytes; 0 if there is none. */
  public synchronized double largest() {
    Map.Entry<Evictable, Score> most = most();
    return most == null ? 0 : most.getValue().grown;
  }

  /** The one whose lobby has grown most, of those not returned yet; null when none has grown. */
  public synchronized @Nullable Evictable next() {
    Map.Entry<Evictable, Score> most = most();
    if (most == null) {
      return null;
    }
    most.getValue().evicted = true;
    return most.getKey();
  }

  private Map.@Nullable Entry<Evictable, Score> most() {
    Map.Entry<Evictable, Score> most = null;
    double grown = 0;
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
