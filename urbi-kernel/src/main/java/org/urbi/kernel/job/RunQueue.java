package org.urbi.kernel.job;

import static org.urbi.kernel.journal.Journal.NOBODY;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.WeakHashMap;
import java.util.function.LongSupplier;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.time.Clock;

/**
 * The jobs that can run, in the order in which they became runnable. A round gives each of them one
 * turn.
 *
 * <p>A round that would delay clients and timers noticeably is cut short. From then on, until the
 * load is over, each budget, which is that of a lobby, has a queue of its own. A round serves them
 * in the order in which they came, each as long as it has jobs and has taken next to no time, or
 * once; it ends after a slice of time, and leaves the rest to the next one. For that it blames one
 * of those it has served, drawn by lot according to the processor time they took, and gives credit
 * to one of those that took next to nothing. Who was to blame more often than others lets them go
 * before. So a lobby that starts a million jobs delays only itself, one that needs little goes
 * first, and a thousand that need the same have equally many turns. In simulated time nobody waits,
 * and rounds are never cut.
 */
class RunQueue {
  /** How long a round may take while others wait, in nanoseconds. */
  static final long SLICE = 5_000_000;

  /** How long a round may take, in nanoseconds, when a timer is due: the next round serves it. */
  private static final long SHORT_SLICE = 1_000_000;

  /** For each round a lobby is to blame for, those go first that came so many rounds later. */
  private static final long DELAY = 50;

  /** For so many rounds more than the others a lobby may be to blame; the rest is forgiven. */
  private static final long LONGEST_MEMORY = 10;

  /** For so many rounds a lobby seems to be to blame that was not here before. */
  private static final long DEBIT = 1;

  /**
   * So many rounds fewer count at most for a lobby that has waited for something else, or needs
   * little: it goes first, however many others have waited longer.
   */
  private static final long CREDIT = 5;

  /**
   * How many jobs of one budget run between two readings of the clock, unless a message arrives,
   * there is a rush, or they are slow; a power of two.
   */
  private static final int JOBS_PER_LOOK = 8;

  /**
   * A lobby of which jobs that have had their turn can run again goes on in the same round so long.
   */
  private static final long GOES_ON = Blame.LITTLE / 2;

  /** In a recording: not the round is over, but the turn of the current lobby. */
  private static final int TURN_OVER = Integer.MAX_VALUE;

  private final Clock clock;
  private final Timers timers;
  private final Inbox inbox;
  private final Journal journal;
  private final boolean counted;
  private final Blame blame;
  private final JobList together = new JobList();

  /**
   * Whether each budget has a queue of its own; {@link #together} then only has jobs for whose
   * queues there is no memory.
   */
  private boolean rushing;

  /** The queues of budgets that still exist. */
  private final Map<Budget, Share> shares = new WeakHashMap<>();

  /** The queues to be served in this round of a rush; none is empty. */
  private final PriorityQueue<Share> round = new PriorityQueue<>(Share.PLACE);

  /** The queues that have been served in this round, or were empty when it began. */
  private final List<Share> served = new ArrayList<>();

  /** An empty queue, which is current when no other is. */
  private final Share nobody = new Share(0, 0);

  private Share current = nobody;

  /** Whose job has run last in this round. */
  private @Nullable Budget last;

  /** How many jobs there are in the queues of a rush. */
  private int waiting;

  private int left;

  /** How many jobs at the head of the queue have been started in this round. */
  private int fresh;

  private boolean freshRuns;

  private int jobs;
  private boolean cuttable;
  private long roundBegan;
  private long looked;

  /** Whether the jobs before the last reading of the clock took long. */
  private boolean slow;

  private long sharesMade;

  /** Whether a job that was started in this round waits behind jobs of its lobby. */
  private boolean elsewhere;

  /** How many rounds rushes have had. */
  private long rounds;

  /**
   * The least {@link Share#roundsCut} of those that want to run and have no credit; it never
   * decreases.
   */
  private long floor;

  /**
   * @param worked the processor time of the loop, in nanoseconds, or {@link HoldWatchdog#UNKNOWN}
   */
  RunQueue(Clock clock, LongSupplier worked, Timers timers, Inbox inbox, Journal journal) {
    this.clock = clock;
    this.blame = new Blame(worked);
    this.timers = timers;
    this.inbox = inbox;
    this.journal = journal;
    this.counted = journal.countsChecks();
  }

  boolean isEmpty() {
    return together.isEmpty() && waiting == 0;
  }

  boolean hasAny(Predicate<Job> condition) {
    return together.hasAny(condition)
        || (waiting > 0
            && shares.values().stream().anyMatch(share -> share.jobs.hasAny(condition)));
  }

  /** Adds a job behind all runnable ones. */
  void add(Job job) {
    JobList queue = queueFor(job);
    if (queue.add(job.turn)) {
      count(queue);
    }
  }

  /** Adds a job before all runnable ones. */
  void addFirst(Job job) {
    JobList queue = queueFor(job);
    if (queue.addFirst(job.turn)) {
      count(queue);
    }
  }

  /**
   * Adds a job that runs next, because the running job has started it, and what follows may rely on
   * what it does first: even if the round is cut short before; unless it {@linkplain #addElsewhere
   * waits elsewhere}.
   */
  void addToRound(Job job) {
    if (addElsewhere(job)) {
      return;
    }
    JobList queue = rushing ? current.jobs : together;
    if (queue.addFirst(job.turn)) {
      count(queue);
      left++;
      fresh++;
    }
  }

  /**
   * In a rush a job of another lobby waits behind the jobs of that lobby: it must not overtake one
   * that has been started before, such as the reaction to an earlier event. Returns whether it is
   * such a job, and has been added.
   */
  boolean addElsewhere(Job job) {
    if (!rushing) {
      return false;
    }
    JobList queue = queueInRush(job);
    if (queue == current.jobs) {
      return false;
    }
    if (queue.add(job.turn)) {
      count(queue);
    }
    elsewhere = true;
    return true;
  }

  boolean isRushing() {
    return rushing;
  }

  /** A job goes on running instead of waiting for its turn. */
  void remove(Job job) {
    JobList queue = job.turn.leave();
    if (queue != null && queue != together) {
      waiting--;
    }
  }

  private void count(JobList joined) {
    if (joined != together) {
      waiting++;
    }
  }

  /** The queue that a job is to join. */
  private JobList queueFor(Job job) {
    return rushing ? queueInRush(job) : together;
  }

  private JobList queueInRush(Job job) {
    if (current != nobody && job.account() == last) {
      return current.jobs;
    }
    try {
      return shareFor(job).jobs;
    } catch (OutOfMemoryError e) {
      return together;
    }
  }

  private Share shareFor(Job job) {
    Share share = shareOf(job.account());
    if (!share.active) {
      served.add(share);
      share.active = true;
      share.roundsCut = Math.max(share.roundsCut, floor - CREDIT);
    }
    return share;
  }

  /** The share of a budget; a test makes this fail as if memory was exhausted. */
  Share shareOf(Budget budget) {
    return shares.computeIfAbsent(budget, known -> new Share(sharesMade++, floor + DEBIT));
  }

  /**
   * Begins a round: of the jobs that are runnable now, and those which they start.
   *
   * @param now what the clock says
   */
  void beginRound(long now) {
    cuttable = clock.isReal();
    roundBegan = now;
    looked = now;
    begin();
  }

  /** Begins a round that is not cut short. */
  void beginWholeRound() {
    cuttable = false;
    begin();
  }

  private void begin() {
    jobs = 0;
    last = null;
    fresh = 0;
    blame.beginRound();
    if (!rushing) {
      left = together.size();
      return;
    }
    rounds++;
    elsewhere = false;
    if (cuttable) {
      blame.beginLook(roundBegan);
    }
    separate();
    while (!served.isEmpty()) {
      Share share = served.getLast();
      if (share.jobs.isEmpty()) {
        share.active = false;
      } else {
        share.place = rounds + DELAY * share.roundsCut;
        round.add(share);
      }
      served.removeLast();
    }
    raiseFloor();
    current = nobody;
    left = 0;
  }

  /** Raises the floor to the least share above it; shares below it have a credit. */
  private void raiseFloor() {
    long least = Long.MAX_VALUE;
    for (Share share : round) {
      if (share.roundsCut >= floor) {
        least = Math.min(least, share.roundsCut);
      }
    }
    if (least < Long.MAX_VALUE) {
      floor = least;
    }
  }

  /** The next job of this round; null at its end. */
  @Nullable Job next() {
    Job job = rushing ? nextInRush() : nextOfAll();
    if (job == null) {
      // Between rounds nobody is remembered: a budget leads to its client, who may have gone.
      last = null;
    }
    return job;
  }

  private @Nullable Job nextOfAll() {
    if (left <= 0) {
      return null;
    }
    Job first = together.first();
    if (first == null) {
      return null;
    }
    Budget account = first.account();
    if (isSliceOver(account)) {
      rush();
      return null;
    }
    left--;
    last = account;
    return poll(together);
  }

  private @Nullable Job nextInRush() {
    Share next = !current.jobs.isEmpty() && (left > 0 || goesOn()) ? current : round.peek();
    if (next == null) {
      if (!elsewhere) {
        relax();
      }
      return null;
    }
    Job first = next.jobs.first();
    if (first != null) {
      Budget account = first.account();
      if (isSliceOver(account)) {
        judge();
        return null;
      }
      last = account;
    }
    if (next != current) {
      endTurn();
      blame.beginTurn(served.size(), looked);
      served.add(next);
      current = round.remove();
      left = current.jobs.size();
      fresh = 0;
    }
    left--;
    Job job = poll(current.jobs);
    if (job != null) {
      waiting--;
    }
    return job;
  }

  /**
   * All jobs of the current lobby have had their turn, and some could run again: whether they may
   * in this round. So who needs little makes up for the periods that it has missed, instead of one
   * in each round, which may be longer than the period.
   */
  private boolean goesOn() {
    if (!cuttable) {
      return false;
    }
    boolean over = clock.now() - blame.turnBegan() >= GOES_ON;
    if (journal.cutsRound(++jobs, over ? TURN_OVER : NOBODY) != NOBODY) {
      return false;
    }
    left = current.jobs.size();
    return true;
  }

  private @Nullable Job poll(JobList queue) {
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

  /** Whether it is too late in this round for another job, of that budget; never for the first. */
  private boolean isSliceOver(Budget next) {
    if (!cuttable) {
      return false;
    }
    boolean looks =
        ++jobs % JOBS_PER_LOOK == 0 || rushing || slow || next != last || inbox.isFilled();
    boolean over = looks && last != null && isLate(clock.now());
    int found = over || counted ? journal.cutsRound(jobs, over ? verdict() : NOBODY) : NOBODY;
    if (found == NOBODY) {
      return false;
    }
    blame.settle(found, nobodysIndex());
    return true;
  }

  private int verdict() {
    endTurn();
    return blame.verdict(nobodysIndex());
  }

  /** Before a rush, the index 0 is that of the lobby that ran last. */
  private int nobodysIndex() {
    return served.size() + 1;
  }

  private void judge() {
    if (blame.culprit() < served.size()) {
      blame(served.get(blame.culprit()));
    }
    if (blame.modest() < served.size()) {
      Share share = served.get(blame.modest());
      share.roundsCut = Math.min(share.roundsCut, Math.max(share.roundsCut - 1, floor - CREDIT));
    }
  }

  /** The current lobby has had its turn. */
  private void endTurn() {
    if (current != nobody) {
      blame.endTurn();
    }
  }

  private boolean isLate(long now) {
    long taken = now - looked;
    long all = now - roundBegan;
    if (rushing) {
      blame.look(now);
    } else {
      blame.lookTogether(taken);
    }
    slow = taken >= SHORT_SLICE;
    looked = now;
    return all >= (timers.next() <= now ? SHORT_SLICE : SLICE);
  }

  private void blame(Share share) {
    share.roundsCut = Math.min(share.roundsCut + 1, floor + LONGEST_MEMORY);
  }

  private void rush() {
    left = 0;
    rushing = true;
    separate();
    if (last != null && blame.culprit() == 0) {
      blame(shareOf(last));
    }
  }

  /** Gives each budget a queue of its own, as far as there is memory for that. */
  private void separate() {
    Budget before = null;
    JobList queue = together;
    for (Job job = together.first(); job != null; job = together.first()) {
      if (job.account() != before) {
        before = job.account();
        queue = queueFor(job);
        if (queue == together) {
          return;
        }
      }
      together.poll();
      queue.add(job.turn);
      waiting++;
    }
  }

  /** Ends the separate queues: all have had their turn in time, and nobody could be overtaken. */
  private void relax() {
    served.sort(Share.AGE);
    for (Share share : served) {
      for (Job job = share.jobs.poll(); job != null; job = share.jobs.poll()) {
        together.add(job.turn);
      }
      share.active = false;
    }
    served.clear();
    waiting = 0;
    rushing = false;
    current = nobody;
  }
}
