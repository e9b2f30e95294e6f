package org.urbi.ros.two;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.urbi.ros.graph.GraphSnapshot;
import org.urbi.ros.graph.RosException;
import urbi.thread.GuardedThreads;

/** Waits for something in the graph, of which a new node hears little by little. */
public final class GraphSeekers {
  private static final Executor TASKS = GuardedThreads.SDK.virtualThreads("urbi-ros-task");

  /** Seconds after which a node knows who is there, if nothing delays it. */
  private static final int FIRST_LOOK = 1;

  /** Seconds after which a node is sure that what it does not know is not there. */
  private static final int LAST_LOOK = 3;

  private final List<Consumer<GraphSnapshot>> watchers = new CopyOnWriteArrayList<>();
  private final List<Runnable> seekers = new CopyOnWriteArrayList<>();
  private final CompletableFuture<Void> looked = after(FIRST_LOOK);
  private final CompletableFuture<Void> sure = after(LAST_LOOK);

  private static CompletableFuture<Void> after(int seconds) {
    return new CompletableFuture<Void>().completeOnTimeout(null, seconds, TimeUnit.SECONDS);
  }

  /**
   * The graph; of a node that has just begun, when it has had time to find the others.
   *
   * @param now tells the graph, on a thread that may wait
   */
  public CompletableFuture<GraphSnapshot> graph(Supplier<GraphSnapshot> now) {
    return looked.thenApplyAsync(nothing -> now.get(), TASKS);
  }

  /**
   * Something that the graph tells, now or soon.
   *
   * @param look what it tells by now
   * @param missing what people are told if the graph does not tell it in time
   */
  public CompletableFuture<String> sought(Supplier<Optional<String>> look, String missing) {
    CompletableFuture<String> found = new CompletableFuture<>();
    Runnable seeker = () -> look.get().ifPresent(found::complete);
    Runnable stopsLooking = seek(seeker);
    seeker.run();
    // What is new is told within that time, too.
    CompletableFuture.allOf(sure, after(FIRST_LOOK))
        .thenRun(() -> found.completeExceptionally(new RosException(missing)));
    return found.whenComplete((value, failure) -> stopsLooking.run());
  }

  /** What {@link #sought} finds, told on a thread that may wait in any case. */
  public CompletableFuture<String> soughtToWait(Supplier<Optional<String>> look, String missing) {
    return sought(look, missing).thenApplyAsync(found -> found, TASKS);
  }

  /**
   * Has something done at each change of the graph, by a thread of the network.
   *
   * @return what ends that
   */
  public Runnable seek(Runnable seeker) {
    seekers.add(seeker);
    return () -> seekers.remove(seeker);
  }

  /** Has a listener told each change; what is returned ends that. */
  public Runnable watch(Consumer<GraphSnapshot> listener) {
    watchers.add(listener);
    return () -> watchers.remove(listener);
  }

  /** The graph has changed. */
  public void changed(Supplier<GraphSnapshot> now) {
    seekers.forEach(Runnable::run);
    tellWatchers(now);
  }

  /** Only what is this node's own has changed. */
  public void tellWatchers(Supplier<GraphSnapshot> now) {
    if (watchers.isEmpty()) return;
    GraphSnapshot told = now.get();
    watchers.forEach(each -> each.accept(told));
  }
}
