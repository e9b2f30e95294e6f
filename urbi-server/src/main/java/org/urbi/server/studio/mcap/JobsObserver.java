package org.urbi.server.studio.mcap;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Connection;
import org.urbi.kernel.observe.View;
import org.urbi.kernel.observe.ViewRequest;
import org.urbi.server.studio.messages.JobTable;
import org.urbi.server.studio.messages.Topic;

/**
 * Looks at the jobs of the kernel and their turns, for a file. Only when what was seen is with the
 * file it looks again: a disk that is slow has less told, and nothing collects here. Used on the
 * thread that writes the file.
 */
final class JobsObserver {
  /** When the first look is due if there is to be none. */
  static final long NEVER = Long.MAX_VALUE;

  /** Between two looks in the middle of a round, and before an answer is asked for again. */
  private static final long SOON = TimeUnit.MILLISECONDS.toNanos(20);

  /** How long an answer to the last look is awaited. */
  private static final long LAST_WAIT = TimeUnit.SECONDS.toNanos(1);

  /** Takes a message: of which topic, its time in nanoseconds since the Epoch, and its content. */
  @FunctionalInterface
  interface Sink {
    void take(Topic topic, long time, Map<String, Object> content) throws IOException;
  }

  private final Connection connection;
  private final Sink sink;
  private final JobTable table = new JobTable();
  private @Nullable CompletableFuture<View> answer;
  private volatile ViewRequest wanted = new ViewRequest(0, List.of(), null, null);
  private long due;

  /**
   * @param first when the first look is due, of the clock that {@link #due} tells, or {@link
   *     #NEVER}
   */
  JobsObserver(Connection connection, Sink sink, long first) {
    this.connection = connection;
    this.sink = sink;
    due = first;
  }

  /** When {@link #goOn} is to be called. */
  long due() {
    return due;
  }

  /**
   * Takes the answer to the last look, if there is one, and looks again.
   *
   * @param now at least {@link #due}
   * @throws ExecutionException if the kernel could not look because of a defect; then this is over
   */
  void goOn(long now) throws IOException, ExecutionException, InterruptedException {
    View view = answered();
    if (answer == null || view != null) {
      look();
    }
    due =
        view != null && view.complete()
            ? now + TimeUnit.MILLISECONDS.toNanos(JobTable.pause(view))
            : now + SOON;
  }

  /**
   * Looks a last time, at all that there is, and waits for that: what jobs have done since the look
   * before is in the file then. A kernel that does not answer soon is left alone.
   */
  void finish() throws IOException, ExecutionException, InterruptedException {
    if (due == NEVER) {
      return;
    }
    try {
      if (answer != null) {
        answer.get(LAST_WAIT, TimeUnit.NANOSECONDS);
        answered();
      }
      boolean complete = false;
      while (!complete) {
        look();
        requireNonNull(answer, "it was just asked").get(LAST_WAIT, TimeUnit.NANOSECONDS);
        View view = answered();
        complete = view == null || view.complete();
      }
    } catch (TimeoutException | CancellationException e) {
      // The file has what was seen before.
    }
  }

  private void look() {
    wanted = new ViewRequest(0, table.oldest(ViewRequest.MOST_TRACED), null, null);
    answer = connection.look(wanted);
  }

  /** What was asked for last; from any thread. */
  ViewRequest wanted() {
    return wanted;
  }

  /** Takes the answer to the last look, if there is one; null if not. */
  @Nullable View answered() throws IOException, ExecutionException, InterruptedException {
    CompletableFuture<View> asked = answer;
    // Of a connection that is closed nobody tells anything more.
    if (asked == null || !asked.isDone() || asked.isCancelled()) {
      return null;
    }
    answer = null;
    View view = asked.get();
    take(view);
    return view;
  }

  /** Takes what the kernel tells at its end, behind the answer to the last look. */
  void takeLast(View view) throws IOException, ExecutionException, InterruptedException {
    answered();
    take(view);
  }

  private void take(View view) throws IOException {
    table.take(view);
    Map<String, Object> turns = JobTable.turns(view);
    if (!turns.isEmpty()) {
      sink.take(Topic.TURNS, view.epochTime(), turns);
    }
    if (view.complete() && table.hasChanged()) {
      sink.take(Topic.JOBS, view.epochTime(), table.message());
    }
  }
}
