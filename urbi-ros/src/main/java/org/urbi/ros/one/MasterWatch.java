package org.urbi.ros.one;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.urbi.ros.graph.RosException;
import urbi.thread.GuardedThreads;

/**
 * Keeps a master informed: looks again and again whether it is there, and tells it everything when
 * it is, or when it is another one than before. One thread does that, in the order in which it was
 * asked.
 */
final class MasterWatch implements AutoCloseable {
  /** Milliseconds between two looks. */
  private static final int PERIOD = 1000;

  private final Api master;
  private final Consumer<Boolean> listener;
  private final ScheduledThreadPoolExecutor thread;
  private final Map<String, Registration> wanted = new LinkedHashMap<>();
  private int pid = -1;

  /**
   * @param listener told after each look whether the master is there
   */
  MasterWatch(Api master, Consumer<Boolean> listener) {
    this.master = master;
    this.listener = listener;
    thread = GuardedThreads.SDK.clock("urbi-ros-master");
    thread.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
    thread.scheduleWithFixedDelay(this::look, 0, PERIOD, TimeUnit.MILLISECONDS);
  }

  /** Has the thread do something; false if it has ended: there is nobody to tell any more. */
  private boolean execute(Runnable task) {
    try {
      thread.execute(task);
      return true;
    } catch (RejectedExecutionException e) {
      return false;
    }
  }

  /** Has the master know of something, as soon as there is one. */
  void add(Registration registration) {
    execute(() -> {
      wanted.put(registration.key(), registration);
      tell();
    });
  }

  /** Has the master forget something. */
  void remove(String key) {
    execute(() -> {
      Registration registration = wanted.remove(key);
      if (registration != null && registration.isKnown()) {
        forget(registration);
      }
    });
  }

  /** Done when the master has been told all that it was to be told by now, if it is there. */
  CompletableFuture<Void> settled() {
    CompletableFuture<Void> done = new CompletableFuture<>();
    if (!execute(() -> done.complete(null))) {
      done.complete(null);
    }
    return done;
  }

  private void forget(Registration registration) {
    try {
      registration.unregister(master).join();
    } catch (CompletionException e) {
      // A master that is away forgets by itself.
      registration.setKnown(false);
    }
  }

  private void look() {
    try {
      int present = master.call(value -> (Integer) value, "getPid").join();
      if (present != pid) {
        pid = present;
        wanted.values().forEach(each -> each.setKnown(false));
      }
      tell();
      listener.accept(true);
    } catch (CompletionException e) {
      pid = -1;
      listener.accept(false);
    }
  }

  private void tell() {
    for (Registration each : wanted.values()) {
      if (!each.isKnown()) {
        try {
          each.register(master).join();
          each.setKnown(true);
        } catch (CompletionException e) {
          boolean refused = e.getCause() instanceof RosException told && told.getCause() == null;
          if (!refused) {
            // Nobody is there: again with the next look.
            return;
          }
        }
      }
    }
  }

  /** Says good-bye to the master, and ends. */
  @Override
  public void close() {
    execute(() -> wanted.values().stream().filter(Registration::isKnown).forEach(this::forget));
    thread.shutdown();
    try {
      thread.awaitTermination(2 * PERIOD, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    thread.shutdownNow();
  }
}
