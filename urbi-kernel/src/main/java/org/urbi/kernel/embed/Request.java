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

/** A task that a job executes and for whose result Java code waits. */
final class Request<T> {
  private final Embedding embedding;
  private final int number;
  private final Embedding.Task<T> task;
  private final CompletableFuture<T> future = new CompletableFuture<>();
  private @Nullable Job job;
  private @Nullable T value;
  private @Nullable Throwable failure;
  private boolean over;
  private volatile @Nullable String evicted;

  Request(Embedding embedding, int number, Embedding.Task<T> task) {
    this.embedding = embedding;
    this.number = number;
    this.task = task;
  }

  /** Completed on the kernel thread: what depends on it must not block. */
  CompletableFuture<T> future() {
    return future;
  }

  /** Cancels the request; from any thread. */
  void cancel() {
    future.cancel(false);
    embedding.scheduler().inbox().post(new Message.EmbeddingCancel(number));
  }

  /** The job is about to be ended, for that reason; from any thread. */
  void evicted(String reason) {
    evicted = reason;
  }

  int number() {
    return number;
  }

  // ------------------------------------------------------------------ on the kernel thread

  /** Starts the job. */
  void begin() {
    if (embedding.isStopping()) {
      fail(Embedding.ended());
    } else if (future.isDone()) {
      embedding.forget(this);
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
      value = task.run(frame);
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

  private void complete() {
    if (failure != null) {
      fail(failure);
    } else {
      embedding.forget(this);
      future.complete(value);
    }
  }

  /** Fails the request, whatever the state of its job. */
  void fail(Throwable reason) {
    embedding.forget(this);
    future.completeExceptionally(reason);
  }
}
