package org.urbi.kernel.library.machine;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/**
 * Looks after sockets and servers (manual, "IoService"): what happens to each of them is kept in a
 * queue of events until somebody polls. The default service polls by itself.
 */
final class UrbiIoService extends UrbiObject {
  private final Set<SocketEvents> filled = new LinkedHashSet<>();
  private final Set<Job> polling = new LinkedHashSet<>();
  private final boolean automatic;
  private boolean paused;

  /**
   * @param automatic whether it is the default one
   */
  UrbiIoService(Shape shape, boolean automatic) {
    super(shape);
    this.automatic = automatic;
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiIoService(cloneShape(), false);
  }

  /** Whether it polls by itself. */
  boolean isAutomatic() {
    return automatic && !paused;
  }

  /** Switches the default service between polling by itself and waiting for polls. */
  void setPaused(boolean value) {
    paused = value;
    if (isAutomatic()) {
      List.copyOf(filled).forEach(SocketEvents::deliverSoon);
    }
  }

  /** A queue of events is no longer empty. */
  void filled(SocketEvents events) {
    filled.add(events);
    if (isAutomatic()) {
      events.deliverSoon();
    }
    List.copyOf(polling).forEach(Job::wake);
  }

  /** Nothing waits there any more. */
  void emptied(SocketEvents events) {
    filled.remove(events);
  }

  /** Delivers what has come so far. */
  void poll(Job job) {
    for (SocketEvents events : new ArrayList<>(filled)) {
      events.deliver(job, Integer.MAX_VALUE);
    }
  }

  /**
   * Delivers what comes until then.
   *
   * @param once whether to return behind the first delivery
   */
  void pollUntil(Job job, long deadline, boolean once) {
    boolean[] over = {job.scheduler().now() >= deadline};
    var timer =
        job.scheduler()
            .timers()
            .add(
                deadline,
                () -> {
                  over[0] = true;
                  job.wake();
                });
    polling.add(job);
    try {
      while (true) {
        boolean delivered = false;
        for (SocketEvents events : new ArrayList<>(filled)) {
          delivered |= events.deliver(job, once ? 1 : Integer.MAX_VALUE);
          if (delivered && once) {
            return;
          }
        }
        if (over[0]) {
          return;
        }
        job.waitForWake(Wait.FILE);
      }
    } finally {
      polling.remove(job);
      timer.cancel();
    }
  }
}
