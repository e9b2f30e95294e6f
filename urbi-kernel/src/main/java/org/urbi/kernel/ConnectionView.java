package org.urbi.kernel;

import static java.util.Objects.requireNonNull;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.observe.Media;
import org.urbi.kernel.observe.Proposal;
import org.urbi.kernel.observe.Proposals;
import org.urbi.kernel.observe.Sample;
import org.urbi.kernel.observe.Steering;
import org.urbi.kernel.observe.View;
import org.urbi.kernel.observe.ViewRequest;
import org.urbi.kernel.observe.Watch;
import org.urbi.lang.input.TypedText;

/** What the client of a connection sees of the kernel, and does to its jobs and tags. */
final class ConnectionView {
  /** What is looked at, by the kernel thread, and who is told. */
  private record Question<T>(Supplier<T> look, CompletableFuture<T> answer) {
    void ask() {
      try {
        answer.complete(look.get());
      } catch (RuntimeException | Error e) {
        answer.completeExceptionally(e);
        throw e;
      }
    }
  }

  /** One who wants to be told what has changed when the kernel ends. */
  private record LastLook(Supplier<ViewRequest> wanted, Consumer<View> told) {}

  private final Kernel kernel;
  private final int number;
  private final Questions<Question<?>> looks;
  private final Questions<CompletableFuture<String>> interventions;
  private volatile @Nullable LastLook lastLook;
  private @Nullable Watch watch;

  /**
   * @param number of the connection
   */
  ConnectionView(Kernel kernel, int number) {
    this.kernel = kernel;
    this.number = number;
    this.looks = new Questions<>(kernel.inbox(), asked -> asked.answer().cancel(false));
    this.interventions = new Questions<>(kernel.inbox(), answer -> answer.cancel(false));
  }

  // ------------------------------------------------------------------ from any thread

  CompletableFuture<View> look(ViewRequest wanted) {
    return ask(() -> watch().look(wanted));
  }

  CompletableFuture<List<Proposal>> propose(Supplier<UrbiLobby> lobby, String text) {
    // What has been typed is looked at here: it may be long.
    TypedText typed = TypedText.of(text);
    return ask(() -> Proposals.of(lobby.get(), typed));
  }

  CompletableFuture<Sample> sample(List<String> ways) {
    return ask(() -> kernel.places().sample(kernel.scheduler().now(), ways));
  }

  CompletableFuture<Optional<Media>> media(String way) {
    return ask(() -> Optional.ofNullable(kernel.places().media(way)));
  }

  private <T> CompletableFuture<T> ask(Supplier<T> look) {
    Question<T> asked = new Question<>(look, new CompletableFuture<>());
    looks.ask(asked, question -> new Message.LookedAt(number, question));
    return asked.answer();
  }

  void lookNoMore() {
    kernel.inbox().post(new Message.LookEnded(number));
  }

  void lookAtEnd(Supplier<ViewRequest> wanted, Consumer<View> told) {
    lastLook = new LastLook(wanted, told);
  }

  CompletableFuture<String> steer(Steering.Action action, boolean tag, long target) {
    return intervene(question -> new Message.Steered(number, question, action.text(), tag, target));
  }

  CompletableFuture<String> emit(long event, String payload) {
    return intervene(question -> new Message.Emitted(number, question, event, payload));
  }

  CompletableFuture<String> assign(String way, String value) {
    return intervene(question -> new Message.Assigned(number, question, way, value));
  }

  private CompletableFuture<String> intervene(IntFunction<Message> message) {
    CompletableFuture<String> answer = new CompletableFuture<>();
    interventions.ask(answer, message);
    return answer;
  }

  // ------------------------------------------------------------------ on the kernel thread

  /** In a replay nobody has asked, and nobody is told. */
  void take(Message.LookedAt message) {
    Question<?> asked = looks.take(message.question());
    if (asked != null) {
      asked.ask();
    }
  }

  private Watch watch() {
    Watch present = watch;
    if (present == null) {
      present = new Watch(kernel.scheduler(), kernel.knownEvents(), kernel.places());
      watch = present;
    }
    return present;
  }

  /** The kernel is about to end: the jobs are as they will have been. */
  void lookLast() {
    LastLook last = lastLook;
    if (last != null) {
      lastLook = null;
      watch().lookAtAll(last.wanted().get(), last.told());
    }
  }

  void take(Message.Steered message, UrbiLobby by) {
    Steering.Action action =
        requireNonNull(Steering.Action.of(message.action()), "it was sent by its name");
    String failure =
        message.tag()
            ? kernel.steering().steerTag(by, action, message.target())
            : kernel.steering().steerJob(by, action, message.target());
    answer(message.question(), failure);
  }

  void take(Message.Emitted message, UrbiLobby by) {
    kernel
        .interventions()
        .emit(by, message.event(), message.payload(), error -> answer(message.question(), error));
  }

  void take(Message.Assigned message, UrbiLobby by) {
    kernel
        .interventions()
        .assign(by, message.way(), message.value(), error -> answer(message.question(), error));
  }

  private void answer(int question, String error) {
    CompletableFuture<String> answer = interventions.take(question);
    if (answer != null) {
      answer.complete(error);
    }
  }

  void endLook() {
    if (watch != null) {
      watch.end();
      watch = null;
    }
  }

  /** The connection is closed. */
  void close() {
    endLook();
    looks.close();
    interventions.close();
  }
}
