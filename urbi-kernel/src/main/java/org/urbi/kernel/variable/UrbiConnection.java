package org.urbi.kernel.variable;

import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** Leads each new value of one variable to another (manual, "Customizing data-flow links"). */
public final class UrbiConnection extends UrbiObject {
  private UrbiUVar source;
  private UrbiUVar target;
  private boolean enabled = true;
  private boolean asynchronous;
  private long minInterval;
  private long lastPassed = Long.MIN_VALUE;
  private boolean passing;
  private long firstPassed;
  private final CallTimes times = new CallTimes();

  public UrbiConnection(Shape shape) {
    super(shape);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiConnection(cloneShape());
  }

  /** Leads the values of a variable to another from now on. */
  public void connect(Frame frame, UrbiUVar from, UrbiUVar to) {
    disconnect();
    source = from;
    target = to;
    from.add(frame, this);
  }

  /** Leads nothing any more. */
  public void disconnect() {
    if (source != null) {
      source.remove(this);
      source = null;
    }
  }

  /** Where the values come from; null when it is disconnected. */
  public UrbiUVar source() {
    return source;
  }

  /** Where they go; null for the prototype. */
  public UrbiUVar target() {
    return target;
  }

  public boolean isEnabled() {
    return enabled;
  }

  public void setEnabled(boolean on) {
    enabled = on;
  }

  /** Whether values go to the target in a job of their own; what comes meanwhile is dropped. */
  public boolean isAsynchronous() {
    return asynchronous;
  }

  public void setAsynchronous(boolean on) {
    asynchronous = on;
  }

  /** The least time between two values, in nanoseconds; what comes earlier is dropped. */
  public long minInterval() {
    return minInterval;
  }

  public void setMinInterval(long nanoseconds) {
    minInterval = nanoseconds;
  }

  /** How often values have been passed, and how long that took. */
  public CallTimes times() {
    return times;
  }

  /** How often a second values have been passed, from the first to the last one. */
  public double fireRate() {
    return times.count() < 2 || lastPassed <= firstPassed
        ? 0
        : (times.count() - 1) * 1e9 / (lastPassed - firstPassed);
  }

  /** There is a new value. */
  void pass(Frame frame, Datum value) {
    Interpreter interpreter = frame.interpreter();
    long now = interpreter.scheduler().now();
    if (!enabled || lastPassed != Long.MIN_VALUE && now - lastPassed < minInterval) {
      return;
    }
    // To read the clock takes as long as the rest: once a tick is enough.
    boolean measured = now != lastPassed;
    if (!asynchronous) {
      begin(now);
      deliver(frame, value, measured);
    } else if (!passing) {
      passing = true;
      begin(now);
      Scheduler scheduler = interpreter.scheduler();
      UrbiObject lobby = frame.job().lobby();
      scheduler
          .startDetached(
              lobby,
              scheduler.rootScope(),
              "connection",
              job ->
                  deliver(Frame.top(interpreter, job, lobby, new FrameLayout()), value, measured))
          .onEnd(() -> passing = false);
    }
  }

  private void begin(long now) {
    if (times.count() == 0) {
      firstPassed = now;
    }
    lastPassed = now;
  }

  private void deliver(Frame frame, Datum value, boolean measured) {
    if (!measured) {
      try {
        target.write(frame, value);
      } finally {
        times.addUnmeasured();
      }
      return;
    }
    long started = frame.interpreter().scheduler().clock().now();
    try {
      target.write(frame, value);
    } finally {
      times.add(frame.interpreter().scheduler().clock().now() - started);
    }
  }
}
