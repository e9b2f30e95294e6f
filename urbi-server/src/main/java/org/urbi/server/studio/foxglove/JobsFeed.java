package org.urbi.server.studio.foxglove;

import io.netty.channel.Channel;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import org.urbi.kernel.Connection;
import org.urbi.kernel.observe.View;
import org.urbi.kernel.observe.ViewRequest;
import org.urbi.server.studio.access.LateAnswers;
import org.urbi.server.studio.messages.JobTable;

/**
 * The jobs of the kernel, for a program that follows them: asked for some times in a second, and
 * told when something has changed. On the thread of the program.
 */
final class JobsFeed {
  /** The number of the channel; variables have those from 1 on. */
  static final int CHANNEL = Integer.MAX_VALUE;

  private static final ViewRequest EVERYTHING = new ViewRequest(0, List.of(), null, null);

  private final Channel channel;
  private final Connection connection;
  private final BiConsumer<Long, Map<String, Object>> tell;
  private final JobTable jobs = new JobTable();
  private boolean followed;
  private boolean looking;

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
    jobs.tellAgain();
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
      connection.lookNoMore();
    }
  }

  private void take(View view) {
    jobs.take(view);
    if (!view.complete()) {
      look();
      return;
    }
    if (jobs.hasChanged() && followed) {
      tell.accept(view.epochTime(), jobs.message());
    }
    Runnable next = LateAnswers.guarding(channel, this::look);
    channel.eventLoop().schedule(next, JobTable.pause(view), TimeUnit.MILLISECONDS);
  }
}
