package org.urbi.kernel;

import java.util.Collection;
import java.util.Map;
import java.util.WeakHashMap;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Meter;

/**
 * Knows which lobby has grown most of late: whose jobs have allocated most since memory is scarce,
 * where what is long ago counts less. What has become garbage since counts as well, for nobody
 * knows whose it was.
 */
final class Growth {
  /** What is left of the weight of something until the next look. */
  private static final double KEPT = 0.98;

  /** How long allocations are watched when nobody has looked before, in milliseconds. */
  private static final long FIRST_LOOK = 50;

  private final Meter meter;
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
  Growth(Meter meter, Collection<KernelConnection> connections) {
    this.meter = meter;
    this.connections = connections;
  }

  /** To be called several times a second while memory is scarce. */
  synchronized void look() {
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
   * The one that has grown most, of those that this has not returned yet; null when nobody has
   * grown.
   */
  synchronized @Nullable KernelConnection next() throws InterruptedException {
    if (scores.isEmpty()) {
      look();
      Thread.sleep(FIRST_LOOK);
    }
    look();
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
