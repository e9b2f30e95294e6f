package org.urbi.ros.uobject;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.RosException;
import urbi.thread.GuardedThreads;
import urbi.thread.InternalFailure;

/**
 * The node, made when it is asked for first. That takes a while, seconds even where the libraries
 * of another middleware are loaded, so it is made on a thread of its own; whoever asks meanwhile
 * waits for the same one. After a failure the next who asks has it tried again.
 */
final class FirstUse implements AutoCloseable {
  private static final String CLOSED = "the node is closed";

  private final Executor threads;
  private @Nullable CompletableFuture<Node> node;
  private boolean closed;

  FirstUse() {
    // A thread of the system: libraries in C need the stack of one.
    this(task -> GuardedThreads.SDK.platform("urbi-ros-node", task).start());
  }

  /**
   * @param threads where a node is made; what that throws is logged there
   */
  FirstUse(Executor threads) {
    this.threads = threads;
  }

  /** Whether there is a node, or soon will be. */
  synchronized boolean hasBegun() {
    return node != null;
  }

  /**
   * The node; does not wait. Fails with a {@link RosException} if it cannot be made, or is closed.
   *
   * @param maker makes it, unless there is one
   */
  CompletionStage<Node> node(Supplier<Node> maker) {
    CompletableFuture<Node> promise;
    synchronized (this) {
      if (closed) {
        return CompletableFuture.failedFuture(new RosException(CLOSED));
      }
      if (node != null) {
        return node;
      }
      promise = new CompletableFuture<>();
      node = promise;
    }
    try {
      threads.execute(() -> make(maker, promise));
    } catch (RuntimeException | Error e) {
      // No thread is left.
      failed(promise, e);
    }
    return promise;
  }

  private void make(Supplier<Node> maker, CompletableFuture<Node> promise) {
    Node made;
    try {
      made = maker.get();
    } catch (RosException e) {
      failed(promise, e);
      return;
    } catch (RuntimeException | Error e) {
      failed(promise, e);
      throw e;
    }
    if (!promise.complete(made)) {
      // The kernel has been closed meanwhile.
      made.close();
    }
  }

  private void failed(CompletableFuture<Node> promise, Throwable reason) {
    synchronized (this) {
      node = null;
    }
    promise.completeExceptionally(
        reason instanceof RosException
            ? reason
            : new RosException("no node of ROS: " + InternalFailure.text(reason), reason));
  }

  /** Ends the node, or, if it is still being made, has it ended when it is. */
  @Override
  public void close() {
    CompletableFuture<Node> known;
    synchronized (this) {
      closed = true;
      known = node;
    }
    if (known != null && !known.completeExceptionally(new RosException(CLOSED))) {
      known.thenAccept(Node::close);
    }
  }
}
