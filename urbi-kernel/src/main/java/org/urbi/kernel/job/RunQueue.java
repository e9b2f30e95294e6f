package org.urbi.kernel.job;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.time.Clock;

/**
 * The jobs that can run, in the order in which they became runnable. A round gives each of them one
 * turn.
 *
 * <p>When a round takes so long that clients and timers would notice, it is cut short, and until
 * the rush is over each lobby has a queue of its own: a round then goes from the lobby that has
 * been cut short least to that which has most, and ends with the one for which a slice of time was
 * not enough. So whoever starts a million jobs waits for them, and nobody else. In simulated time
 * nobody waits, and rounds are never cut.
 */
final class RunQueue {
  /** How long the jobs of one lobby may take in a round, in nanoseconds, when others wait. */
  private static final long SLICE = 5_000_000;

  /** How long a round may take in all when it takes more than a slice. */
  private static final long LONGEST_ROUND = 2 * SLICE;

  /** Between two looks at the clock so many jobs run, unless there is news; a power of two. */
  private static final int JOBS_PER_LOOK = 8;

  private final Clock clock;
  private final Inbox inbox;
  private final Journal journal;
  private final boolean counted;
  private final ArrayDeque<Job> together = new ArrayDeque<>();

  /** The queues of the lobbies, null when there is no rush; {@link #together} is empty then. */
  private @Nullable Map<UrbiObject, LobbyQueue> shares;

  /** Has no jobs: whose turn it is when it is nobody's. */
  private final LobbyQueue nobody = new LobbyQueue(0, 0);

  /** What is left of this round in a rush, first to run last. */
  private final List<LobbyQueue> round = new ArrayList<>();

  private LobbyQueue current = nobody;
  private int left;
  private int jobs;
  private boolean cuttable;
  private long roundBegan;
  private long sliceBegan;
  private long sharesMade;

  /** The jobs of one lobby. */
  private static final class LobbyQueue {
    final ArrayDeque<Job> jobs = new ArrayDeque<>();
    final long number;

    /** How many slices have not been enough. */
    long roundsCut;

    LobbyQueue(long number, long roundsCut) {
      this.number = number;
      this.roundsCut = roundsCut;
    }
  }

  RunQueue(Clock clock, Inbox inbox, Journal journal) {
    this.clock = clock;
    this.inbox = inbox;
    this.journal = journal;
    this.counted = journal.countsChecks();
  }

  boolean isEmpty() {
    if (shares == null) {
      return together.isEmpty();
    }
    for (LobbyQueue share : shares.values()) {
      if (!share.jobs.isEmpty()) {
        return false;
      }
    }
    return true;
  }

  boolean hasAny(Predicate<Job> condition) {
    if (shares == null) {
      return together.stream().anyMatch(condition);
    }
    return shares.values().stream().anyMatch(share -> share.jobs.stream().anyMatch(condition));
  }

  /** It can run, after all that can. */
  void add(Job job) {
    (shares == null ? together : shareOf(shares, job).jobs).add(job);
  }

  /** It can run, before all that can. */
  void addFirst(Job job) {
    (shares == null ? together : shareOf(shares, job).jobs).addFirst(job);
  }

  /** It runs next in this round: the job that ran last has started it. */
  void addToRound(Job job) {
    if (shares == null) {
      together.addFirst(job);
      left++;
      return;
    }
    LobbyQueue share = shareOf(shares, job);
    share.jobs.addFirst(job);
    if (share == current) {
      left++;
    }
  }

  private LobbyQueue shareOf(Map<UrbiObject, LobbyQueue> all, Job job) {
    return all.computeIfAbsent(
        job.lobby(), lobby -> new LobbyQueue(sharesMade++, fewestRoundsCut(all)));
  }

  /** Who comes later has no credit from the time before. */
  private static long fewestRoundsCut(Map<UrbiObject, LobbyQueue> all) {
    return all.values().stream().mapToLong(share -> share.roundsCut).min().orElse(0);
  }

  /**
   * Begins a round, of those that can run now and those whom they start.
   *
   * @param now the time of the clock
   * @param whole whether it is not to be cut short
   */
  void beginRound(long now, boolean whole) {
    cuttable = !whole && clock.isReal();
    jobs = 0;
    roundBegan = now;
    sliceBegan = now;
    if (shares == null) {
      left = together.size();
      return;
    }
    round.clear();
    shares.values().removeIf(share -> share.jobs.isEmpty());
    round.addAll(shares.values());
    round.sort(
        Comparator.comparingLong((LobbyQueue share) -> share.roundsCut)
            .thenComparingLong(share -> share.number)
            .reversed());
    current = nobody;
    left = 0;
  }

  /** The next one in this round; null when it is over. */
  @Nullable Job next() {
    if (shares == null) {
      if (left > 0 && isSliceOver()) {
        rush();
        return null;
      }
      return left-- > 0 ? together.poll() : null;
    }
    while (left <= 0) {
      if (round.isEmpty()) {
        relax(shares);
        return null;
      }
      current = round.removeLast();
      left = current.jobs.size();
      sliceBegan = cuttable ? clock.now() : 0;
    }
    if (isSliceOver()) {
      current.roundsCut++;
      return null;
    }
    left--;
    return current.jobs.poll();
  }

  private boolean isSliceOver() {
    if (!cuttable) {
      return false;
    }
    boolean over = (++jobs % JOBS_PER_LOOK == 0 || inbox.isFilled()) && isLate(clock.now());
    return (over || counted) && journal.cutsRound(jobs, over);
  }

  private boolean isLate(long now) {
    return now - sliceBegan >= SLICE || now - roundBegan >= LONGEST_ROUND;
  }

  private void rush() {
    left = 0;
    Map<UrbiObject, LobbyQueue> rush = new IdentityHashMap<>();
    shares = rush;
    together.forEach(job -> shareOf(rush, job).jobs.add(job));
    together.clear();
  }

  /** Everybody had his turn in time. */
  private void relax(Map<UrbiObject, LobbyQueue> rush) {
    List<LobbyQueue> all = new ArrayList<>(rush.values());
    all.sort(Comparator.comparingLong(share -> share.number));
    shares = null;
    current = nobody;
    all.forEach(share -> together.addAll(share.jobs));
  }
}
