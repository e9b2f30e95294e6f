package org.urbi.kernel;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Outcome;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.observe.GivenSlot;
import org.urbi.kernel.observe.VariableFeed;
import org.urbi.kernel.observe.VariableListener;

/** What the client of a connection is told of variables, and gives to them. */
final class ConnectionFeed {
  private record Question(List<String> paths, CompletableFuture<List<@Nullable Object>> answer) {}

  private final Kernel kernel;
  private final int number;
  private final AtomicInteger questions = new AtomicInteger();
  private final Map<Integer, Question> asked = new ConcurrentHashMap<>();
  private final Map<Integer, CompletableFuture<String>> given = new ConcurrentHashMap<>();

  /** In a replay nobody listens. */
  private volatile VariableListener listener = VariableListener.NONE;

  private volatile boolean closed;
  private @Nullable VariableFeed feed;

  /**
   * @param number of the connection
   */
  ConnectionFeed(Kernel kernel, int number) {
    this.kernel = kernel;
    this.number = number;
  }

  // ------------------------------------------------------------------ from any thread

  void begin(VariableListener told, boolean all, List<String> paths) {
    listener = told;
    kernel.inbox().post(new Message.FeedBegun(number, all, String.join("\n", paths)));
  }

  CompletableFuture<List<@Nullable Object>> values(List<String> paths) {
    Question question = new Question(List.copyOf(paths), new CompletableFuture<>());
    int id = questions.incrementAndGet();
    asked.put(id, question);
    kernel.inbox().post(new Message.ValuesAsked(number, id));
    cancelIfClosed();
    return question.answer();
  }

  CompletableFuture<String> give(String path, @Nullable Object value) {
    CompletableFuture<String> answer = new CompletableFuture<>();
    int id = questions.incrementAndGet();
    given.put(id, answer);
    kernel.inbox().post(new Message.ValueGiven(number, id, path, new Outcome(value, null)));
    cancelIfClosed();
    return answer;
  }

  private void cancelIfClosed() {
    if (closed) {
      asked.values().forEach(each -> each.answer().cancel(false));
      given.values().forEach(each -> each.cancel(false));
      asked.clear();
      given.clear();
    }
  }

  // ------------------------------------------------------------------ on the kernel thread

  void take(Message.OfVariables message, UrbiLobby lobby) {
    if (message instanceof Message.FeedBegun begun) {
      if (feed == null) {
        feed =
            new VariableFeed(
                kernel.interpreter(),
                kernel.logLines(),
                this::roots,
                listener,
                begun.all(),
                begun.paths().lines().toList());
      }
    } else if (message instanceof Message.Followed followed) {
      if (feed != null) {
        feed.follow(followed.variable(), followed.on());
      }
    } else if (message instanceof Message.ValuesAsked question) {
      Question wanted = asked.remove(question.question());
      if (wanted != null) {
        wanted.answer().complete(seen(wanted.paths()));
      }
    } else if (message instanceof Message.ValueGiven gift) {
      give(lobby, gift);
    }
  }

  /** The names of slots are those of all lobbies, whose code has them, and global ones. */
  private List<UrbiObject> roots() {
    List<UrbiObject> roots = new ArrayList<>(kernel.lobbies().all());
    roots.add(kernel.interpreter().world().prototype("Global"));
    return roots;
  }

  /** Another lobby has been opened. */
  void lobbyOpened() {
    if (feed != null) {
      feed.rootsChanged();
    }
  }

  private @Nullable GivenSlot find(String path) {
    return feed == null
        ? VariableFeed.find(kernel.interpreter(), this::roots, path)
        : feed.find(path);
  }

  private List<@Nullable Object> seen(List<String> paths) {
    List<@Nullable Object> values = new ArrayList<>();
    for (String path : paths) {
      GivenSlot slot = find(path);
      values.add(slot == null ? null : slot.seen());
    }
    return values;
  }

  private void give(UrbiLobby lobby, Message.ValueGiven gift) {
    GivenSlot slot = find(gift.path());
    if (slot == null) {
      done(gift, Problem.NO_SLOT_AT.text(gift.path()));
      return;
    }
    // Until its job ends, it has not been done.
    String[] outcome = {Problem.WAS_STOPPED.text()};
    kernel
        .scheduler()
        .startDetached(
            lobby,
            kernel.scheduler().rootScope(),
            "given",
            job -> outcome[0] = give(job, lobby, slot, gift.value().value()))
        .onEnd(() -> done(gift, outcome[0]));
  }

  private String give(Job job, UrbiLobby lobby, GivenSlot slot, @Nullable Object value) {
    TagScope scope = job.enter(lobby.connectionTag().state());
    try {
      slot.give(Frame.top(kernel.interpreter(), job, lobby, new FrameLayout()), value);
      return "";
    } catch (UrbiException e) {
      return Utf8Text.toJava(ErrorText.describe(kernel.interpreter(), e.unlessUncatchable()));
    } finally {
      job.leave(scope);
    }
  }

  private void done(Message.ValueGiven gift, String outcome) {
    CompletableFuture<String> answer = given.remove(gift.question());
    if (answer != null) {
      answer.complete(outcome);
    }
  }

  /** The connection is closed. */
  void close() {
    closed = true;
    if (feed != null) {
      feed.end();
      feed = null;
    }
    cancelIfClosed();
  }
}
