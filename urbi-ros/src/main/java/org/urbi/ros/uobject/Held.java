package org.urbi.ros.uobject;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.RosException;

/**
 * What an object has of the network, which takes a while to be there. If nobody wants it when it is
 * there, it is closed: the job that waited for it was stopped, or the object has ended.
 */
final class Held<T> implements AutoCloseable {
  private final Consumer<T> closer;
  private @Nullable T held;
  private boolean closed;

  /**
   * @param closer closes one
   */
  Held(Consumer<T> closer) {
    this.closer = closer;
  }

  /** What there is. */
  synchronized @Nullable T get() {
    return held;
  }

  /**
   * One is to be held when it is there, in place of what there is.
   *
   * @param then is done before whoever waits goes on
   * @return for the job that waits; whoever cancels it does not want it any more
   */
  CompletableFuture<Void> hold(CompletionStage<T> coming, Runnable then) {
    CompletableFuture<Void> job = new CompletableFuture<>();
    coming.whenComplete((made, failure) -> {
      if (failure != null) {
        job.completeExceptionally(failure);
        return;
      }
      end(put(made, job));
      if (get() != made) {
        job.completeExceptionally(new RosException("it is not wanted any more"));
        return;
      }
      then.run();
      if (!job.complete(null)) {
        // It was given up at the last moment.
        end(remove(made));
      }
    });
    return job;
  }

  /** Returns what is not held then. */
  private synchronized @Nullable T put(T made, CompletableFuture<Void> job) {
    if (closed || job.isDone()) {
      return made;
    }
    T before = held;
    held = made;
    return before;
  }

  private synchronized @Nullable T remove(T made) {
    if (held != made) {
      return null;
    }
    held = null;
    return made;
  }

  private void end(@Nullable T unwanted) {
    if (unwanted != null) {
      closer.accept(unwanted);
    }
  }

  /** Closes it; what comes later is closed when it comes. */
  @Override
  public void close() {
    T present;
    synchronized (this) {
      closed = true;
      present = held;
      held = null;
    }
    end(present);
  }
}
