package org.urbi.kernel.observe;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Located;
import org.urbi.kernel.job.Place;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.TurnMeter;
import org.urbi.lang.source.Span;

/**
 * One who looks at the jobs and tags of a kernel, and is told what has changed. Each look takes a
 * limited time, in which the jobs wait: several make a round over all that there is. On the kernel
 * thread, between the turns.
 */
public final class Watch {
  /** Of how many turns one look tells at most. */
  private static final int MOST_TURNS = 1000;

  private static final double SECOND = 1e9;

  private final Scheduler scheduler;
  private final TurnMeter meter;
  private final WorldTime time;
  private final SeenTags tags = new SeenTags();
  private final SeenJobs jobs;
  private final KnownEvents events;
  private final Places places;
  private @Nullable SeenReactions reactions;
  private @Nullable SeenVariables variables;

  // What has been seen of the round that has begun.
  private boolean begun;
  private boolean jobsSeen;
  private @Nullable ReactionView reacting;
  private @Nullable VariableView varying;

  private List<Job> traced = List.of();

  /** Since when all turns of each of them have been told: of the machine's time. */
  private Map<Long, Long> tracedSince = Map.of();

  /** Since when the first turns of new jobs have been told. */
  private long toldSince;

  private long nextTurn;

  /** The round is not over before the turns up to this one have been told. */
  private long lastTurn;

  /** Begins to look; to be {@linkplain #end ended}. */
  public Watch(Scheduler scheduler, KnownEvents events, Places places) {
    this.scheduler = scheduler;
    time = new WorldTime(scheduler);
    this.events = events;
    this.places = places;
    meter = scheduler.observation().begin();
    jobs = new SeenJobs(scheduler, meter, tags);
    nextTurn = meter.next();
    toldSince = meter.now();
  }

  /** Looks no longer. */
  public void end() {
    traced.forEach(meter::endTrace);
    traced = List.of();
    scheduler.observation().end();
  }

  /** What has changed since the last look. */
  public View look(ViewRequest wanted) {
    long now = meter.now();
    // Those of the jobs that were traced until now: others may be from now on.
    TurnView turning = turns(now);
    if (!begun) {
      begin(wanted, now);
      turning = withTraced(turning);
    }
    Allowance allowance = new Allowance();
    List<JobRow> changed = new ArrayList<>();
    List<Long> gone = new ArrayList<>();
    jobsSeen = jobsSeen || jobs.look(now, allowance, changed, gone);
    boolean complete =
        jobsSeen
            && hasReactions(wanted.reactions(), allowance)
            && hasVariables(wanted.objects(), allowance)
            && nextTurn >= lastTurn;
    View view =
        new View(
            now,
            scheduler.now(),
            time.now(),
            scheduler.jobCount(),
            changed,
            gone,
            tags.changes(complete),
            complete ? tags.gone() : List.of(),
            turning,
            complete ? detail(wanted.selected()) : null,
            complete ? reacting : null,
            complete ? varying : null,
            complete);
    begun = !complete;
    return view;
  }

  /**
   * Tells all that has changed until now, also in the turn of the job that runs, in as many looks
   * as it takes: nobody is to run any more.
   */
  public void lookAtAll(ViewRequest wanted, Consumer<View> told) {
    scheduler.observation().cutTurn();
    while (begun) {
      told.accept(look(wanted));
    }
    do {
      told.accept(look(wanted));
    } while (begun);
  }

  private void begin(ViewRequest wanted, long now) {
    begun = true;
    jobsSeen = false;
    reacting = null;
    varying = null;
    lastTurn = meter.next();
    jobs.begin(now);
    List<Job> before = traced;
    traced = wanted.traced().stream().map(jobs::job).filter(job -> job != null).toList();
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

  /**
   * Looks at the reactions and events.
   *
   * @param text null if nobody wants to see them: then all that was told is forgotten
   * @return whether that is done in this round
   */
  private boolean hasReactions(@Nullable String text, Allowance allowance) {
    if (text == null) {
      reactions = null;
      reacting = null;
      return true;
    }
    if (reacting == null) {
      SeenReactions known = reactions == null ? new SeenReactions(events, tags) : reactions;
      reactions = known;
      reacting = known.look(text, allowance);
    }
    return reacting != null;
  }

  /**
   * Looks at the slots of objects.
   *
   * @param ways null if nobody wants to see them: then all that was told is forgotten
   * @return whether that is done in this round
   */
  private boolean hasVariables(@Nullable List<String> ways, Allowance allowance) {
    if (ways == null) {
      variables = null;
      varying = null;
      return true;
    }
    if (varying == null) {
      SeenVariables known = variables == null ? new SeenVariables(places) : variables;
      variables = known;
      varying = known.look(ways, allowance);
    }
    return varying != null;
  }

  private TurnView turns(long now) {
    long from = nextTurn;
    if (traced.isEmpty()) {
      nextTurn = meter.next();
      toldSince = now;
      return new TurnView(List.of(), 0, null);
    }
    long lostUntil = meter.lostUntil(from);
    toldSince = Math.max(toldSince, lostUntil);
    nextTurn = Math.min(meter.next(), Math.max(from, meter.oldest()) + MOST_TURNS);
    return new TurnView(meter.turns(from, nextTurn, tracedSince.keySet()), lostUntil, null);
  }

  private @Nullable JobDetail detail(long number) {
    Job job = jobs.job(number);
    if (job == null) {
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
