package org.urbi.server.studio.messages;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.urbi.kernel.job.Turn;
import org.urbi.kernel.observe.JobRow;
import org.urbi.kernel.observe.TagRow;
import org.urbi.kernel.observe.TurnView;
import org.urbi.kernel.observe.View;

/** The jobs of a kernel as messages, put together of what somebody is told who looks at them. */
public final class JobTable {
  /** Between two rounds over the jobs, in milliseconds. */
  private static final int PERIOD = 250;

  /** So many jobs make that longer by a millisecond: to look must not cost more for them. */
  private static final int JOBS_PER_MILLISECOND = 20;

  /** Of how many jobs, the oldest, a message tells. */
  private static final int MOST = 500;

  private static final double PER_MILLE = 1000;
  private static final double SECOND = 1e9;

  private final TreeMap<Long, JobRow> jobs = new TreeMap<>();
  private final Map<Long, TagRow> tags = new LinkedHashMap<>();
  private boolean changed;

  /** How long to wait after a round over the jobs before the next one, in milliseconds. */
  public static int pause(View view) {
    return PERIOD + view.total() / JOBS_PER_MILLISECOND;
  }

  /** Takes what has changed. */
  public void take(View view) {
    view.tags().forEach(each -> tags.put(each.number(), each));
    view.tagsGone().forEach(tags::remove);
    view.jobs().forEach(each -> jobs.put(each.number(), each));
    view.gone().forEach(jobs::remove);
    changed |= !view.jobs().isEmpty() || !view.gone().isEmpty() || !view.tags().isEmpty();
  }

  /** Whether there is something that the last {@link #message} did not tell. */
  public boolean hasChanged() {
    return changed;
  }

  /** The next message is to be told although nothing has changed. */
  public void tellAgain() {
    changed = true;
  }

  /** Forgets all jobs and tags. */
  public void clear() {
    jobs.clear();
    tags.clear();
  }

  /** The numbers of the oldest jobs. */
  public List<Long> oldest(int most) {
    return jobs.keySet().stream().limit(most).toList();
  }

  /** The jobs, as {@link Topic#JOBS} has them. */
  public Map<String, Object> message() {
    changed = false;
    List<Object> rows = new ArrayList<>();
    jobs.values().stream().limit(MOST).map(this::row).forEach(rows::add);
    Map<String, Object> message = new LinkedHashMap<>();
    message.put("total", (double) jobs.size());
    message.put("jobs", rows);
    return message;
  }

  private Map<String, Object> row(JobRow job) {
    Map<String, Object> row = new LinkedHashMap<>();
    row.put("number", (double) job.number());
    row.put("name", job.name());
    row.put("starter", (double) job.starter());
    row.put("lobby", job.lobby());
    row.put("waits", job.waits());
    row.put("frozen", job.frozen());
    row.put("place", job.place());
    row.put("code", job.code());
    row.put("tags", tagNames(job));
    row.put("share", job.share() / PER_MILLE);
    return row;
  }

  private List<String> tagNames(JobRow job) {
    List<String> names = new ArrayList<>();
    for (long number : job.tags()) {
      TagRow tag = tags.get(number);
      if (tag != null) {
        names.add(tag.name());
      }
    }
    return names;
  }

  /** The turns of a view, as {@link Topic#TURNS} has them; empty if it has nothing to tell. */
  public static Map<String, Object> turns(View view) {
    TurnView told = view.turns();
    Map<String, Object> message = new LinkedHashMap<>();
    Map<Long, Long> traced = told.traced();
    if (told.turns().isEmpty() && told.lostUntil() == 0 && traced == null) {
      return message;
    }
    message.put("machine", view.machine() / SECOND);
    message.put("lostUntil", told.lostUntil() / SECOND);
    if (traced != null) {
      List<Object> since = new ArrayList<>();
      traced.forEach((job, begin) -> {
        Map<String, Object> one = new LinkedHashMap<>();
        one.put("job", (double) job);
        one.put("since", begin / SECOND);
        since.add(one);
      });
      message.put("traced", since);
    }
    List<Object> turns = new ArrayList<>();
    told.turns().forEach(each -> turns.add(turn(each)));
    message.put("turns", turns);
    return message;
  }

  private static Map<String, Object> turn(Turn turn) {
    Map<String, Object> row = new LinkedHashMap<>();
    row.put("job", (double) turn.job());
    row.put("begin", turn.begin() / SECOND);
    row.put("end", turn.end() / SECOND);
    row.put("waited", turn.before().text());
    row.put("wakers", turn.wakers().stream().map(Long::doubleValue).toList());
    row.put("ended", turn.ended());
    return row;
  }
}
