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
 * <p>A round that would delay clients and timers noticeably is cut short. From then on, until the
 * load is over, each lobby has a queue of its own, and a round serves the lobbies in order, those
 * first whose turns have been cut short least often; it ends with the lobby for which its slice of
 * time was not enough. So a lobby that starts a million jobs delays only itself. In simulated time
 * nobody waits, and rounds are never cut.
 */
final class RunQueue {
  /** How long the jobs of one lobby may run in a round while others wait, in nanoseconds. */
  private static final long SLICE = 5_000_000;

  /** How long a whole round may take, in nanoseconds, if it takes more than a slice. */
  private static final long LONGEST_ROUND = 2 * SLICE;

  /**
   * How many jobs run between two readings of the clock, unless a message arrives; a power of two.
   */
  private static final int JOBS_PER_LOOK = 8;

  private final Clock clock;
  private final Inbox inbox;
  private final Journal journal;
  private final boolean counted;
  private final ArrayDeque<Job> together = new ArrayDeque<>();

  /** The queues of the lobbies under high load, when {@link #together} is empty; null otherwise. */
  private @Nullable Map<UrbiObject, LobbyQueue> shares;

  /** An empty queue, which is current when no lobby's is. */
  private final LobbyQueue nobody = new LobbyQueue(0, 0);

  /** The queues still to be served in this round under high load; the next one is last. */
  private final List<LobbyQueue> round = new ArrayList<>();

  private LobbyQueue current = nobody;
  private int left;

  /** How many jobs at the head of the queue have been started in this round. */
  private int fresh;

  private boolean freshRuns;

  private int jobs;
  private boolean cuttable;
  private long roundBegan;
  private long sliceBegan;
  private long sharesMade;

  /** The jobs of one lobby. */
  private static final class LobbyQueue {
    final ArrayDeque<Job> jobs = new ArrayDeque<>();
    final long number;

    /** How often the slice of this lobby was not enough. */
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

  /** Adds a job behind all runnable ones. */
  void add(Job job) {
    (shares == null ? together : shareOf(shares, job).jobs).add(job);
  }

  /** Adds a job before all runnable ones. */
  void addFirst(Job job) {
    (shares == null ? together : shareOf(shares, job).jobs).addFirst(job);
  }

  /**
   * Adds a job that runs next, because the running job has started it, and what follows may rely on
   * what it does first: even if the round is cut short before.
   */
  void addToRound(Job job) {
    if (shares == null) {
      together.addFirst(job);
      left++;
      fresh++;
      return;
    }
    LobbyQueue share = shareOf(shares, job);
    share.jobs.addFirst(job);
    if (share == current) {
      left++;
      fresh++;
    }
  }

  private LobbyQueue shareOf(Map<UrbiObject, LobbyQueue> all, Job job) {
    return all.computeIfAbsent(
        job.lobby(), lobby -> new LobbyQueue(sharesMade++, fewestRoundsCut(all)));
  }

  /**
   * A lobby that joins later starts with the lowest count of the others: it must not be preferred
   * for long.
   */
  private static long fewestRoundsCut(Map<UrbiObject, LobbyQueue> all) {
    return all.values().stream().mapToLong(share -> share.roundsCut).min().orElse(0);
  }

  /**
   * Begins a round: of the jobs that are runnable now, and those which they start.
   *
   * @param now the time of the clock
   * @param whole whether the round must not be cut short
   */
  void beginRound(long now, boolean whole) {
    cuttable = !whole && clock.isReal();
    jobs = 0;
    roundBegan = now;
    sliceBegan = now;
    fresh = 0;
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

  /** The next job of this round; null at its end. */
  @Nullable Job next() {
    if (shares == null) {
      if (left > 0 && isSliceOver()) {
        rush();
        return null;
      }
      return left-- > 0 ? poll(together) : null;
    }
    while (left <= 0) {
      if (round.isEmpty()) {
        relax(shares);
        return null;
      }
      current = round.removeLast();
      fresh = 0;
      left = current.jobs.size();
      sliceBegan = cuttable ? clock.now() : 0;
    }
    if (isSliceOver()) {
      current.roundsCut++;
      return null;
    }
    left--;
    return poll(current.jobs);
  }

  private @Nullable Job poll(ArrayDeque<Job> queue) {
    freshRuns = fresh > 0;
    if (freshRuns) {
      fresh--;
    }
    return queue.poll();
  }

  /** Whether the job whose turn it is has been started in this round. */
  boolean isFresh() {
    return freshRuns;
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

  /** Ends the separate queues: all jobs have had their turn in time. */
  private void relax(Map<UrbiObject, LobbyQueue> rush) {
    List<LobbyQueue> all = new ArrayList<>(rush.values());
    all.sort(Comparator.comparingLong(share -> share.number));
    shares = null;
    current = nobody;
    all.forEach(share -> together.addAll(share.jobs));
  }
}
