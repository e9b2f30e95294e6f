package org.urbi.kernel.library.machine;

import java.util.ArrayDeque;
import java.util.function.BooleanSupplier;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobOwner;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;

/**
 * The queue of events of one socket or server that have not been delivered yet; used on the kernel
 * thread.
 */
final class SocketEvents {
  /** An event, which is delivered with a frame for calling urbiscript. */
  interface SocketEvent {
    void tell(Frame frame);
  }

  /** How long a step of waiting for the first listener takes, in nanoseconds. */
  private static final long LISTENER_WAIT = 5_000_000;

  private static final int STEPS = 20;

  /** When to try again if the job that was to deliver could not begin, in nanoseconds. */
  private static final long RETRY = 100_000_000;

  private final Interpreter interpreter;
  private final UrbiIoService service;
  private final UrbiObject lobby;
  private final BooleanSupplier wanted;
  private final ArrayDeque<SocketEvent> events = new ArrayDeque<>();
  private boolean open;
  private boolean fresh = true;
  private boolean delivering;

  /** Whether the job that delivers has taken an event. */
  private boolean told;

  /**
   * @param wanted whether there is a listener
   */
  SocketEvents(Frame frame, UrbiIoService service, BooleanSupplier wanted) {
    this.interpreter = frame.interpreter();
    this.service = service;
    this.lobby = frame.job().lobby();
    this.wanted = wanted;
  }

  /** From now on events may be delivered. */
  void open() {
    open = true;
    announce();
  }

  void add(SocketEvent event) {
    events.add(event);
    announce();
  }

  private void announce() {
    if (open && !events.isEmpty()) {
      service.filled(this);
    }
  }

  /** Delivers what is there in a job of its own, unless that is being done. */
  void deliverSoon() {
    if (!delivering) {
      Job started =
          JobOwner.start(
              interpreter.scheduler(),
              lobby,
              "socket",
              job -> {
                awaitListener(job);
                tellAll(job, Integer.MAX_VALUE);
              });
      delivering = true;
      told = false;
      started.onEnd(this::delivered);
    }
  }

  /** A job that delivers has ended, perhaps before it began. */
  private void delivered() {
    delivering = false;
    if (told) {
      announce();
    } else {
      // Its lobby may have as many jobs as it is allowed to.
      Scheduler scheduler = interpreter.scheduler();
      scheduler.timers().add(scheduler.now() + RETRY, this::announce);
    }
  }

  /** Code that has just got the socket needs a moment to begin to listen. */
  private void awaitListener(Job job) {
    for (int i = 0; i < STEPS && fresh && !wanted.getAsBoolean(); i++) {
      job.sleepUntil(job.scheduler().now() + LISTENER_WAIT);
    }
    fresh = false;
  }

  /** Delivers at most that many events; returns whether there were any. */
  boolean deliver(Job job, int maximum) {
    if (delivering || events.isEmpty()) {
      return false;
    }
    delivering = true;
    try {
      tellAll(job, maximum);
    } finally {
      delivering = false;
      announce();
    }
    return true;
  }

  private void tellAll(Job job, int maximum) {
    Frame frame = Frame.top(interpreter, job, lobby, new FrameLayout());
    for (int i = 0; i < maximum && !events.isEmpty(); i++) {
      SocketEvent event = events.poll();
      told = true;
      if (events.isEmpty()) {
        service.emptied(this);
      }
      try {
        event.tell(frame);
      } catch (UrbiException e) {
        interpreter.report(job, e.unlessUncatchable());
      }
    }
  }
}
