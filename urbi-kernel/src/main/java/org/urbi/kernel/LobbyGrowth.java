package org.urbi.kernel;

import java.util.Collection;
import java.util.Map;
import java.util.WeakHashMap;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.UsageMeter;

/**
 * Finds the lobby that has grown most lately: the one whose jobs have allocated most since memory
 * became scarce, where recent allocations weigh more. Memory that has become garbage since counts,
 * too, because nobody knows whose it was.
 */
final class LobbyGrowth {
  /** The factor by which older allocations lose weight at each measurement. */
  private static final double KEPT = 0.98;

  /** How long to measure, in milliseconds, when there is no earlier measurement to compare with. */
  private static final long FIRST_LOOK = 50;

  private final UsageMeter meter;
  private final Collection<KernelConnection> connections;
  private final Map<KernelConnection, Score> scores = new WeakHashMap<>();

  private static final class Score {
    long bytes;
    double grown;
    boolean evicted;
  }

  /**
   * @param connections all there are, at any time
   */
  LobbyGrowth(UsageMeter meter, Collection<KernelConnection> connections) {
    this.meter = meter;
    this.connections = connections;
  }

  /** To be called several times a second while memory is scarce. */
  synchronized void measure() {
    meter.begin();
    for (KernelConnection each : connections) {
      long bytes = meter.bytes(each.lobby().budget());
      Score score = scores.computeIfAbsent(each, unknown -> new Score());
      score.grown = score.grown * KEPT + bytes - score.bytes;
      score.bytes = bytes;
    }
  }

  /** Memory is not scarce any more. */
  synchronized void forget() {
    scores.clear();
  }

  /**
   * The connection whose lobby has grown most, of those not returned yet; null when none has grown.
   */
  synchronized @Nullable KernelConnection next() throws InterruptedException {
    if (scores.isEmpty()) {
      measure();
      Thread.sleep(FIRST_LOOK);
    }
    measure();
    KernelConnection most = null;
    Score highest = null;
    double grown = 0;
    for (KernelConnection each : connections) {
      Score score = scores.get(each);
      if (score != null && !score.evicted && score.grown > grown) {
        most = each;
        highest = score;
        grown = score.grown;
      }
    }
    if (highest != null) {
      highest.evicted = true;
    }
    return most;
  }
}
