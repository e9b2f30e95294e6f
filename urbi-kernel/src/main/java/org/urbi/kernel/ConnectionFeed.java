package org.urbi.kernel;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntFunction;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.message.Data;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.observe.CallEnd;
import org.urbi.kernel.observe.GivenSlot;
import org.urbi.kernel.observe.VariableFeed;
import org.urbi.kernel.observe.VariableListener;

/** What the client of a connection is told of variables, gives to them, and calls. */
final class ConnectionFeed {
  private record Question(List<String> paths, CompletableFuture<List<@Nullable Object>> answer) {}

  /** What is done with a slot, in a job; it returns what the client is told. */
  @FunctionalInterface
  private interface Work {
    @Nullable Object run(GivenSlot slot, Frame frame);
  }

  private final Kernel kernel;
  private final int number;
  private final AtomicInteger questions = new AtomicInteger();
  private final Map<Integer, Question> asked = new ConcurrentHashMap<>();
  private final Map<Integer, CompletableFuture<CallEnd>> given = new ConcurrentHashMap<>();

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
    Data sent = new Data(value);
    return post(id -> new Message.ValueGiven(number, id, path, sent)).thenApply(CallEnd::error);
  }

  CompletableFuture<CallEnd> call(String path, List<@Nullable Object> arguments) {
    Data sent = new Data(arguments);
    return post(id -> new Message.FunctionCalled(number, id, path, sent));
  }

  private CompletableFuture<CallEnd> post(IntFunction<Message> message) {
    CompletableFuture<CallEnd> answer = new CompletableFuture<>();
    int id = questions.incrementAndGet();
    given.put(id, answer);
    kernel.inbox().post(message.apply(id));
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
      Object value = gift.value().value();
      begin(
          lobby,
          "given",
          gift.path(),
          gift.question(),
          (slot, frame) -> {
            slot.give(frame, value);
            return null;
          });
    } else if (message instanceof Message.FunctionCalled call) {
      List<?> arguments = call.arguments().value() instanceof List<?> list ? list : List.of();
      begin(
          lobby,
          "called",
          call.path(),
          call.question(),
          (slot, frame) -> slot.call(frame, arguments));
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

  private void begin(UrbiLobby lobby, String name, String path, int question, Work work) {
    GivenSlot slot = find(path);
    if (slot == null) {
      done(question, new CallEnd(Problem.NO_SLOT_AT.text(path), null));
      return;
    }
    // Until its job ends, it has not been done.
    CallEnd[] outcome = {new CallEnd(Problem.WAS_STOPPED.text(), null)};
    kernel
        .scheduler()
        .startDetached(
            lobby,
            kernel.scheduler().rootScope(),
            name,
            job -> outcome[0] = run(job, lobby, slot, work))
        .onEnd(() -> done(question, outcome[0]));
  }

  private CallEnd run(Job job, UrbiLobby lobby, GivenSlot slot, Work work) {
    TagScope scope = job.enter(lobby.connectionTag().state());
    try {
      Frame frame = Frame.top(kernel.interpreter(), job, lobby, new FrameLayout());
      return new CallEnd("", work.run(slot, frame));
    } catch (UrbiException e) {
      String error = ErrorText.describe(kernel.interpreter(), e.unlessUncatchable());
      return new CallEnd(Utf8Text.toJava(error), null);
    } finally {
      job.leave(scope);
    }
  }

  private void done(int question, CallEnd outcome) {
    CompletableFuture<CallEnd> answer = given.remove(question);
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
