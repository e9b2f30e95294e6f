package org.urbi.kernel.library.concurrent;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Timers;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.tag.UrbiTag;

/** A tag whose code has limited time (manual, "Timeout"). */
final class UrbiTimeout extends UrbiTag {
  private long nanoseconds;
  private boolean throwing = true;
  private boolean timedOut;
  private int running;
  private Timers.@Nullable Timer timer;

  UrbiTimeout(Shape shape) {
    super(shape);
  }

  @Override
  public UrbiObject cloned() {
    UrbiTimeout clone = new UrbiTimeout(cloneShape());
    clone.nanoseconds = nanoseconds;
    clone.throwing = throwing;
    return clone;
  }

  void set(long limit, boolean throwsException) {
    nanoseconds = limit;
    throwing = throwsException;
  }

  boolean timedOut() {
    return timedOut;
  }

  /** Begins to count down. */
  void launch(Frame frame) {
    if (timer != null) {
      timer.cancel();
    }
    timedOut = false;
    var scheduler = frame.job().scheduler();
    UrbiObject nothing = frame.interpreter().values().voidObject;
    timer =
        scheduler
            .timers()
            .add(
                scheduler.deadline(nanoseconds),
                () -> {
                  timer = null;
                  timedOut = true;
                  state().stop(scheduler, nothing);
                });
  }

  @Override
  protected void entering(Frame frame) {
    if (running++ == 0) {
      launch(frame);
    }
  }

  @Override
  protected void left(Frame frame) {
    if (--running == 0 && timer != null) {
      timer.cancel();
      timer = null;
    }
  }

  @Override
  protected UrbiObject stopped(Frame frame, UrbiObject value) {
    if (timedOut && throwing) {
      String name = frame.interpreter().asString(frame, this);
      throw frame.interpreter().errors().of(Problem.TIMED_OUT, name).build();
    }
    return value;
  }
}
