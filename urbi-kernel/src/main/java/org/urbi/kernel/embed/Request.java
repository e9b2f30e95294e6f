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
  private final Beside beside;
  private final CompletableFuture<T> future = new CompletableFuture<>();
  private @Nullable Job job;
  private @Nullable Object value;
  private @Nullable Throwable failure;
  private boolean over;
  private volatile @Nullable String evicted;

  Request(Embedding embedding, Message.OfProgram asked, Beside beside) {
    this.embedding = embedding;
    this.asked = asked;
    this.beside = beside;
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

  /** The job is about to be ended, for that reason; from any thread. */
  void evicted(String reason) {
    evicted = reason;
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
      job.onEnd(this::jobEnded);
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
    try {
      value = embedding.tasks().run(frame, asked, beside);
      over = true;
    } catch (TagStop stop) {
      throw stop;
    } catch (ControlFlowException unwinding) {
      // A return or break outside of functions and loops: the result is void.
      over = true;
    } catch (Throwable thrown) {
      failure = UrbiErrorConverter.of(embedding, frame, thrown);
      over = true;
    } finally {
      running.leave(scope);
    }
  }

  private void jobEnded() {
    embedding.finished();
    try {
      if (!over) {
        failure = ended();
      }
      // Complete after the output of this tick, outside of the thread of the job.
      embedding.scheduler().atEndOfTick(this::complete);
    } catch (OutOfMemoryError e) {
      fail(e);
    }
  }

  private Exception ended() {
    if (embedding.isStopping()) {
      return Embedding.ended();
    }
    String reason = evicted;
    return reason == null
        ? new CancellationException("the evaluation was stopped")
        : UrbiErrorConverter.simple(reason, null);
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
