package urbi.remote;

import java.util.Iterator;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import urbi.thread.GuardedThreads;

/** The timers of the UObjects of a remote process. */
final class RemoteTimers implements AutoCloseable {
  /** The shortest period, in microseconds. */
  private static final long MIN_LENGTH = 1000;

  private record Timer(Object owner, ScheduledFuture<?> future) {}

  private final Dispatcher dispatcher;
  private final List<Timer> all = new CopyOnWriteArrayList<>();
  private final ScheduledThreadPoolExecutor clock = GuardedThreads.SDK.clock("urbi-remote-timer");

  RemoteTimers(Dispatcher dispatcher) {
    this.dispatcher = dispatcher;
    clock.setRemoveOnCancelPolicy(true);
  }

  /**
   * Has something done in turn with the calls of functions, now and then periodically. What takes
   * longer than its period is not made up for.
   *
   * @param guard executes a task, and never throws
   */
  Runnable every(Object owner, double milliseconds, Runnable action, Consumer<Runnable> guard) {
    dispatcher.expectTasks();
    long period = Math.max(MIN_LENGTH, (long) (milliseconds * 1000));
    var waiting = new AtomicBoolean();
    ScheduledFuture<?> future =
        clock.scheduleAtFixedRate(
            () -> {
              if (waiting.compareAndSet(false, true)) {
                dispatcher.run(() -> {
                  waiting.set(false);
                  guard.accept(action);
                });
              }
            },
            0,
            period,
            TimeUnit.MICROSECONDS);
    Timer timer = new Timer(owner, future);
    all.add(timer);
    return () -> {
      future.cancel(false);
      all.remove(timer);
    };
  }

  /** Ends what belongs to a UObject. */
  void end(Object owner) {
    for (Iterator<Timer> each = all.iterator(); each.hasNext(); ) {
      Timer timer = each.next();
      if (timer.owner == owner) {
        timer.future.cancel(false);
        all.remove(timer);
      }
    }
  }

  @Override
  public void close() {
    clock.shutdownNow();
  }
}
