package org.urbi.kernel.job;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.time.Clock;

/**
 * Measures how long the turns of each job last, while somebody looks, and keeps the latest ones of
 * the jobs that are traced. On the kernel thread.
 */
public final class TurnMeter {
  /** How many turns are kept: whoever looks too rarely misses some. */
  private static final int KEPT = 1 << 13;

  /**
   * When there are more than so many since somebody has asked, those of jobs that only let others
   * run in between are joined: jobs that never wait must not take the room of all the others.
   */
  private static final int MANY = KEPT / 2;

  /** How long such a job has let others run, at most, in nanoseconds. */
  private static final long SHORT = 100_000;

  /** How many jobs that have just been started are traced, before anybody can ask for them. */
  private static final int MOST_NEWBORN = 64;

  /** How many turns of each of them: there is room for those of all, and for others. */
  private static final int FIRST_TURNS = 64;

  /** Of a job that wakes others, it is known who had started it, and so on: so many jobs in all. */
  private static final int WAKERS = 4;

  /** What is measured of a job; made when it first is, so that jobs nobody looks at have none. */
  static final class Measures {
    /** Who made it runnable, who had started that job, and so on; 0 where there is none. */
    private final long[] wakers = new long[WAKERS];

    /** Who had started it, who had started that job, and so on, as far as that was seen. */
    private final long[] starters = new long[WAKERS - 1];

    private long ran;
    private int tracers;
    private int firstTurns;

    /** The number of its latest turn that was kept. */
    private long latest;

    /** When it was started, if its first turns are kept. */
    private long born;

    /** The number of the latest of its {@linkplain ChangedJobs changes} that was noted. */
    long changed;

    private boolean isTraced() {
      return tracers > 0 || firstTurns > 0;
    }
  }

  private final Clock machine;
  private final ChangedJobs changes;

  // The turns that are kept. To keep one takes no memory: if it did, a job could lose its turn when
  // there is none.
  private final long[] jobs = new long[KEPT];
  private final long[] wakers = new long[WAKERS * KEPT];
  private final long[] begins = new long[KEPT];
  private final long[] ends = new long[KEPT];
  private final @Nullable Wait[] waits = new Wait[KEPT];
  private final boolean[] last = new boolean[KEPT];
  private final boolean[] first = new boolean[KEPT];

  /** Counts for the jobs for whose measures there was no memory. */
  private final Measures lost = new Measures();

  private long next;

  /** The number of the first turn that nobody has been told of. */
  private long untold;

  private @Nullable Job charged;
  private long since;
  private Wait before = Wait.TURN;
  private int tracers;
  private int newborn;

  /** Of the job whose turn it is: it may be woken again before that is over. */
  private final long[] wakersNow = new long[WAKERS];

  /**
   * @param firstChange the number of the first change of a job: see {@link ChangedJobs}
   */
  TurnMeter(Clock machine, long firstChange) {
    this.machine = machine;
    changes = new ChangedJobs(firstChange);
  }

  /** Which jobs have changed. */
  public ChangedJobs changes() {
    return changes;
  }

  private Measures measures(Job job) {
    Measures known = job.measures;
    if (known == null) {
      try {
        known = new Measures();
        known.starters[0] = job.starter();
      } catch (OutOfMemoryError e) {
        // The job must have its turn all the same.
        return lost;
      }
      job.measures = known;
    }
    return known;
  }

  /** A job has changed: it has a turn, is new, or was frozen or unfrozen. */
  void changed(Job job) {
    changed(job, measures(job));
  }

  private void changed(Job job, Measures measures) {
    if (measures == lost) {
      changes.changed(job);
    } else {
      changes.changed(job, measures);
    }
  }

  /** A job has ended. */
  void ended(Job job) {
    Measures known = job.measures;
    changes.ended(job, known == null ? lost : known);
  }

  /** A job has become runnable because of another one; null if because of something else. */
  void woken(Job job, @Nullable Job by) {
    Measures measures = measures(job);
    if (by == null) {
      Arrays.fill(measures.wakers, 0);
    } else {
      measures.wakers[0] = by.number();
      System.arraycopy(measures(by).starters, 0, measures.wakers, 1, WAKERS - 1);
    }
  }

  /** A job has been started by another one; null if by something else. */
  void started(Job job, @Nullable Job by) {
    Measures measures = measures(job);
    if (by != null) {
      System.arraycopy(measures(by).starters, 0, measures.starters, 1, WAKERS - 2);
    }
    woken(job, by);
    changes.started(job);
    changed(job, measures);
    if (tracers > 0 && newborn < MOST_NEWBORN) {
      newborn++;
      measures.firstTurns = FIRST_TURNS;
      measures.born = machine.now();
    }
  }

  /** The turn passes to a job; null if to none. */
  void turnOf(@Nullable Job following) {
    if (following == charged) {
      return;
    }
    long now = machine.now();
    Job done = charged;
    if (done != null) {
      Measures measures = measures(done);
      measures.ran += now - since;
      if (measures.isTraced()) {
        keep(done, measures, now);
      }
    }
    if (following != null) {
      before = following.waitsFor();
      Measures measures = measures(following);
      System.arraycopy(measures.wakers, 0, wakersNow, 0, WAKERS);
      changed(following, measures);
    }
    charged = following;
    since = now;
  }

  private void keep(Job done, Measures measures, long now) {
    int latest = (int) (measures.latest % KEPT);
    if (next - untold > MANY && goesOn(done, measures.latest, latest)) {
      ends[latest] = now;
      last[latest] = done.state() == JobState.ENDED;
      return;
    }
    measures.latest = next;
    int at = (int) (next++ % KEPT);
    first[at] = measures.firstTurns > 0;
    measures.firstTurns = Math.max(0, measures.firstTurns - 1);
    jobs[at] = done.number();
    System.arraycopy(wakersNow, 0, wakers, WAKERS * at, WAKERS);
    begins[at] = since;
    ends[at] = now;
    waits[at] = before;
    last[at] = done.state() == JobState.ENDED;
  }

  /** Whether the turn of a job that is over is one with an earlier one, for whoever looks. */
  private boolean goesOn(Job done, long number, int at) {
    return number >= Math.max(untold, next - KEPT)
        && number < next
        && jobs[at] == done.number()
        && wakersNow[0] == done.number()
        && since - ends[at] < SHORT;
  }

  /** The time of the machine, in nanoseconds. */
  public long now() {
    return machine.now();
  }

  /** How long the turns of a job have lasted while somebody looked, in nanoseconds. */
  public long ran(Job job) {
    Measures known = job.measures;
    return known == null ? 0 : known.ran;
  }

  /** One more wants to see the turns of a job. */
  public void beginTrace(Job job) {
    tracers++;
    measures(job).tracers++;
  }

  /** Ends one {@link #beginTrace}. */
  public void endTrace(Job job) {
    tracers--;
    measures(job).tracers--;
  }

  /** The number that the next turn of a traced job gets. */
  public long next() {
    return next;
  }

  /** The number of the oldest turn that is kept. */
  public long oldest() {
    return Math.max(0, next - KEPT);
  }

  /** Since when the turns of a job are kept for all, because it is new; now if they are not. */
  public long firstTurnsSince(Job job) {
    Measures measures = measures(job);
    return measures.firstTurns > 0 ? measures.born : machine.now();
  }

  /** When the oldest turn began that is kept of those from a number on; 0 if none is lost. */
  public long lostUntil(long from) {
    return from < oldest() ? begins[(int) (next % KEPT)] : 0;
  }

  /**
   * The turns of some of the traced jobs, and the first ones of jobs that were started since, as
   * far as they are still kept. Those of jobs that others have traced, perhaps not all the time,
   * are left out.
   *
   * @param from the number of the first one that is wanted
   * @param to the number of the first one that is not wanted any more; at most {@link #next}
   * @param wanted the numbers of the jobs
   */
  public List<Turn> turns(long from, long to, Set<Long> wanted) {
    newborn = 0;
    untold = to;
    List<Turn> turns = new ArrayList<>();
    for (long number = Math.max(from, oldest()); number < to; number++) {
      int at = (int) (number % KEPT);
      Wait wait = waits[at];
      if (wait != null && (first[at] || wanted.contains(jobs[at]))) {
        turns.add(new Turn(jobs[at], wakers(at), begins[at], ends[at], wait, last[at]));
      }
    }
    return turns;
  }

  private List<Long> wakers(int at) {
    List<Long> known = new ArrayList<>(WAKERS);
    for (int i = WAKERS * at; i < WAKERS * (at + 1) && wakers[i] != 0; i++) {
      known.add(wakers[i]);
    }
    return known;
  }
}
