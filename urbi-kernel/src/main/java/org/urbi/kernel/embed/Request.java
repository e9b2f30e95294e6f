package org.urbi.kernel.embed;

import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.TagStop;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;

/** What a job does for the program, and for whose result Java code waits; not in a replay. */
final class Request<T> {
  private final Embedding embedding;
  private final Message.OfProgram asked;
  private final RequestAttachments attached;
  private final CompletableFuture<T> future = new CompletableFuture<>();
  private @Nullable Job job;
  private @Nullable Object value;
  private @Nullable Throwable failure;
  private boolean over;

  Request(Embedding embedding, Message.OfProgram asked, RequestAttachments attached) {
    this.embedding = embedding;
    this.asked = asked;
    this.attached = attached;
  }

  /** Completed on the kernel thread: what depends on it must not block. */
  CompletableFuture<T> future() {
    return future;
  }

  /** Cancels the request; from any thread. */
  void cancel() {
    future.cancel(false);
    embedding.scheduler().inbox().post(new Message.EmbeddingCancel(asked.number()));
  }

  int number() {
    return asked.number();
  }

  // ------------------------------------------------------------------ on the kernel thread

  /** Starts the job, even if nobody waits for it any more: a message will say so. */
  void begin() {
    if (embedding.refuses()) {
      fail(Embedding.ended());
    } else {
      UrbiLobby lobby = embedding.began();
      job =
          embedding
              .scheduler()
              .startDetached(lobby, embedding.scheduler().rootScope(), "eval", this::run);
      long number = job.number();
      job.onEnd(() -> jobEnded(number));
    }
  }

  /** The request was cancelled. */
  void cancelled() {
    if (job != null) {
      job.terminate();
    }
  }

  private void run(Job running) {
    UrbiLobby lobby = (UrbiLobby) running.lobby();
    Frame frame = Frame.top(embedding.interpreter(), running, lobby, new FrameLayout());
    TagScope scope = running.enter(lobby.connectionTag().state());
    embedding.eviction().begins(running);
    try {
      value = embedding.tasks().run(frame, asked, attached);
      over = true;
    } catch (TagStop stop) {
      throw stop;
    } catch (ControlFlowException unwinding) {
      // A return or break outside of functions and loops: the result is void.
      over = true;
    } catch (Throwable thrown) {
      // Who asks next must not suffer from what is decided about this one.
      embedding.scheduler().memory().recover(thrown);
      embedding.scheduler().beginTurn();
      failure = UrbiErrorConverter.of(embedding, frame, thrown);
      over = true;
    } finally {
      running.leave(scope);
    }
  }

  private void jobEnded(long number) {
    embedding.finished();
    try {
      if (!over) {
        failure = ended(number);
      }
      // Complete after the output of this tick, outside of the thread of the job.
      embedding.scheduler().atEndOfTick(this::complete);
    } catch (OutOfMemoryError e) {
      fail(e);
    }
  }

  private Exception ended(long number) {
    if (embedding.isStopping()) {
      return Embedding.ended();
    }
    String reason = embedding.eviction().reasonFor(number);
    return reason == null ? stopped() : UrbiErrorConverter.simple(reason, null);
  }

  static CancellationException stopped() {
    return new CancellationException("the evaluation was stopped");
  }

  // The program asks for what the task of its message returns.
  @SuppressWarnings("unchecked")
  private void complete() {
    if (failure != null) {
      fail(failure);
    } else {
      embedding.forget(this);
      future.complete((T) value);
    }
  }

  /** Fails the request, whatever the state of its job. */
  void fail(Throwable reason) {
    embedding.forget(this);
    future.completeExceptionally(reason);
  }
}
