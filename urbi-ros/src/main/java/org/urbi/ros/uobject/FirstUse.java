package org.urbi.ros.uobject;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.function.Function;
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

  /** The settings of the node that there is, or soon will be. */
  private @Nullable NodeSettings settings;

  /** Whether somebody has asked for the node: then it remains what it is. */
  private boolean used;

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

  /** What the node was made with that somebody uses; null as long as nobody has asked for it. */
  synchronized @Nullable NodeSettings used() {
    return used ? settings : null;
  }

  /**
   * The node; does not wait. Fails with a {@link RosException} if it cannot be made, or is closed.
   *
   * @param wanted what it is made with, unless there is one that somebody uses
   * @param maker makes it
   */
  CompletionStage<Node> node(NodeSettings wanted, Function<NodeSettings, Node> maker) {
    return node(wanted, maker, true);
  }

  /**
   * Makes the node before anybody uses it. If other settings are chosen until then, it makes room
   * for another one.
   */
  CompletionStage<Node> ahead(NodeSettings wanted, Function<NodeSettings, Node> maker) {
    return node(wanted, maker, false);
  }

  private CompletionStage<Node> node(
      NodeSettings wanted, Function<NodeSettings, Node> maker, boolean uses) {
    CompletableFuture<Node> promise;
    CompletableFuture<Node> before;
    synchronized (this) {
      if (closed) {
        return CompletableFuture.failedFuture(new RosException(CLOSED));
      }
      before = node;
      if (before != null && (used || !uses || wanted.equals(settings))) {
        used |= uses;
        return before;
      }
      promise = new CompletableFuture<>();
      node = promise;
      settings = wanted;
      used = uses;
    }
    try {
      threads.execute(() -> {
        makeRoom(before);
        make(() -> maker.apply(wanted), promise);
      });
    } catch (RuntimeException | Error e) {
      // No thread is left.
      makeRoom(before);
      failed(promise, e);
    }
    return promise;
  }

  private static void makeRoom(@Nullable CompletableFuture<Node> before) {
    if (before != null) {
      before.whenComplete((made, failure) -> {
        if (made != null) {
          made.close();
        }
      });
    }
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
      if (node == promise) {
        node = null;
        used = false;
      }
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
