package org.urbi.server.studio.foxglove;

import io.netty.channel.Channel;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import org.urbi.kernel.Connection;
import org.urbi.kernel.observe.JobRow;
import org.urbi.kernel.observe.TagRow;
import org.urbi.kernel.observe.View;
import org.urbi.kernel.observe.ViewRequest;
import org.urbi.server.studio.access.LateAnswers;

/**
 * The jobs of the kernel, for a program that follows them: asked for some times in a second, and
 * told when something has changed. On the thread of the program.
 */
final class JobsFeed {
  /** The number of the channel; variables have those from 1 on. */
  static final int CHANNEL = Integer.MAX_VALUE;

  /** Between two looks, in milliseconds. */
  private static final int PERIOD = 250;

  /** So many jobs make that longer by a millisecond. */
  private static final int JOBS_PER_MILLISECOND = 20;

  /** Of how many jobs, the oldest, a message tells. */
  private static final int MOST = 500;

  private static final double PER_MILLE = 1000;
  private static final ViewRequest EVERYTHING = new ViewRequest(0, List.of(), null, null);

  private final Channel channel;
  private final Connection connection;
  private final BiConsumer<Long, Map<String, Object>> tell;
  private final TreeMap<Long, JobRow> jobs = new TreeMap<>();
  private final Map<Long, TagRow> tags = new LinkedHashMap<>();
  private boolean followed;
  private boolean looking;
  private boolean changed;

  /**
   * @param tell takes a message: its time in nanoseconds since the Epoch, and its content
   */
  JobsFeed(Channel channel, Connection connection, BiConsumer<Long, Map<String, Object>> tell) {
    this.channel = channel;
    this.connection = connection;
    this.tell = tell;
  }

  /** Begins to tell of jobs, at first of those that there are; or ends it. */
  void follow(boolean on) {
    followed = on;
    changed = true;
    if (on && !looking) {
      looking = true;
      look();
    }
  }

  private void look() {
    if (followed) {
      LateAnswers.take(channel, connection.look(EVERYTHING), this::take);
    } else {
      looking = false;
      jobs.clear();
      tags.clear();
      connection.lookNoMore();
    }
  }

  private void take(View view) {
    view.tags().forEach(each -> tags.put(each.number(), each));
    view.tagsGone().forEach(tags::remove);
    view.jobs().forEach(each -> jobs.put(each.number(), each));
    view.gone().forEach(jobs::remove);
    changed |= !view.jobs().isEmpty() || !view.gone().isEmpty() || !view.tags().isEmpty();
    if (!view.complete()) {
      look();
      return;
    }
    if (changed && followed) {
      changed = false;
      tell.accept(view.epochTime(), message());
    }
    int pause = PERIOD + view.total() / JOBS_PER_MILLISECOND;
    Runnable next = LateAnswers.guarding(channel, this::look);
    channel.eventLoop().schedule(next, pause, TimeUnit.MILLISECONDS);
  }

  private Map<String, Object> message() {
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
}
