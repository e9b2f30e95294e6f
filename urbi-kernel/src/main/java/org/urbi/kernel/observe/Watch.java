package org.urbi.kernel.observe;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobState;
import org.urbi.kernel.job.Located;
import org.urbi.kernel.job.Place;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.TurnMeter;
import org.urbi.lang.source.Span;

/**
 * One who looks at the jobs and tags of a kernel, and is told what has changed. To look takes a
 * limited time: of very many jobs a part each time. On the kernel thread, between the turns.
 */
public final class Watch {
  /** How many jobs are looked at in one tick: where nothing has changed, that is soon seen. */
  private static final int JOBS_AT_ONCE = 2500;

  /** How many of them may have changed: to tell of those takes longer. */
  private static final int ROWS_AT_ONCE = 500;

  private static final double SECOND = 1e9;

  private final Scheduler scheduler;
  private final TurnMeter meter;
  private final WorldTime time;
  private final SeenTags tags = new SeenTags();
  private final KnownEvents events;
  private final Places places;
  private @Nullable SeenReactions reactions;
  private @Nullable SeenVariables variables;
  private List<SeenJob> seen = new ArrayList<>();
  private List<SeenJob> seenNow = new ArrayList<>();
  private List<Job> round = List.of();
  private int next;
  private int known;
  private List<Job> traced = List.of();

  /** Since when all turns of each of them have been told: of the machine's time. */
  private Map<Long, Long> tracedSince = Map.of();

  /** Since when the first turns of new jobs have been told. */
  private long toldSince;

  private long nextTurn;

  /** Begins to look; to be {@linkplain #end ended}. */
  public Watch(Scheduler scheduler, KnownEvents events, Places places) {
    this.scheduler = scheduler;
    time = new WorldTime(scheduler);
    this.events = events;
    this.places = places;
    meter = scheduler.beginObservation();
    nextTurn = meter.next();
    toldSince = meter.now();
  }

  /** Looks no longer. */
  public void end() {
    traced.forEach(meter::endTrace);
    traced = List.of();
    round = List.of();
    scheduler.endObservation();
  }

  /** What has changed since the last look. */
  public View look(ViewRequest wanted) {
    long now = meter.now();
    // Those of the jobs that were traced until now: others may be from now on.
    TurnView turning = turns(now);
    if (next == round.size()) {
      begin(wanted);
      turning = withTraced(turning);
    }
    List<JobRow> changed = new ArrayList<>();
    List<Long> gone = new ArrayList<>();
    int end = Math.min(next + JOBS_AT_ONCE, round.size());
    for (; next < end && changed.size() < ROWS_AT_ONCE; next++) {
      Job job = round.get(next);
      if (job.state() != JobState.ENDED) {
        SeenJob one = find(job, gone, now);
        if (one.update(job, tags, now, meter.ran(job))) {
          changed.add(one.row(job));
        }
        seenNow.add(one);
      }
    }
    boolean complete = next == round.size();
    if (complete) {
      for (; known < seen.size(); known++) {
        gone.add(seen.get(known).number());
      }
      seen = seenNow;
    }
    ReactionView reacting = complete ? reactions(wanted.reactions()) : null;
    VariableView varying = complete ? variables(wanted.objects()) : null;
    return new View(
        now,
        scheduler.now(),
        time.now(),
        round.size(),
        changed,
        gone,
        tags.changes(complete),
        complete ? tags.gone() : List.of(),
        turning,
        complete ? detail(wanted.selected()) : null,
        reacting,
        varying,
        complete);
  }

  private void begin(ViewRequest wanted) {
    round = scheduler.jobs();
    next = 0;
    known = 0;
    seenNow = new ArrayList<>(round.size());
    List<Job> before = traced;
    traced = wanted.traced().stream().map(this::job).filter(job -> job != null).toList();
    // In this order, so that those that go on being traced are so without a break.
    traced.forEach(meter::beginTrace);
    before.forEach(meter::endTrace);
  }

  private TurnView withTraced(TurnView turning) {
    Map<Long, Long> since = new LinkedHashMap<>();
    for (Job job : traced) {
      Long before = tracedSince.get(job.number());
      long known = before == null ? meter.firstTurnsSince(job) : before;
      since.put(job.number(), Math.max(known, toldSince));
    }
    boolean same = since.equals(tracedSince);
    tracedSince = since;
    return same ? turning : new TurnView(turning.turns(), turning.lostUntil(), since);
  }

  /** What is known of a job. Both lists are in the order of the numbers. */
  private SeenJob find(Job job, List<Long> gone, long now) {
    while (known < seen.size() && seen.get(known).number() < job.number()) {
      gone.add(seen.get(known++).number());
    }
    boolean is = known < seen.size() && seen.get(known).number() == job.number();
    return is ? seen.get(known++) : new SeenJob(job, now, meter.ran(job));
  }

  /** The job of that number in this round; null if there is none. */
  private @Nullable Job job(long number) {
    int low = 0;
    int high = round.size() - 1;
    while (low <= high) {
      int middle = (low + high) >>> 1;
      Job found = round.get(middle);
      if (found.number() == number) {
        return found;
      } else if (found.number() < number) {
        low = middle + 1;
      } else {
        high = middle - 1;
      }
    }
    return null;
  }

  /**
   * @param text null if nobody wants to see reactions: then all that was told is forgotten
   */
  private @Nullable ReactionView reactions(@Nullable String text) {
    if (text == null) {
      reactions = null;
      return null;
    }
    if (reactions == null) {
      reactions = new SeenReactions(events, tags);
    }
    return reactions.look(text);
  }

  /**
   * @param ways null if nobody wants to see variables: then all that was told is forgotten
   */
  private @Nullable VariableView variables(@Nullable List<String> ways) {
    if (ways == null) {
      variables = null;
      return null;
    }
    if (variables == null) {
      variables = new SeenVariables(places);
    }
    return variables.look(ways);
  }

  private TurnView turns(long now) {
    long from = nextTurn;
    nextTurn = meter.next();
    if (traced.isEmpty()) {
      toldSince = now;
      return new TurnView(List.of(), 0, null);
    }
    long lostUntil = meter.lostUntil(from);
    toldSince = Math.max(toldSince, lostUntil);
    return new TurnView(meter.turns(from, tracedSince.keySet()), lostUntil, null);
  }

  private @Nullable JobDetail detail(long number) {
    Job job = job(number);
    if (job == null || job.state() == JobState.ENDED) {
      return null;
    }
    List<JobDetail.Call> calls = new ArrayList<>();
    Located where = job.where();
    Span span = where == null ? null : where.span();
    if (span != null) {
      calls.add(new JobDetail.Call("", Written.place(span), Written.line(span)));
    }
    Place place = job.place();
    if (place != null) {
      place
          .backtrace()
          .forEach(call ->
              calls.add(
                  new JobDetail.Call(
                      call.name(), Written.place(call.span()), Written.line(call.span()))));
    }
    double left = job.deadline() < 0 ? -1 : (job.deadline() - scheduler.now()) / SECOND;
    return new JobDetail(number, left, calls);
  }
}
