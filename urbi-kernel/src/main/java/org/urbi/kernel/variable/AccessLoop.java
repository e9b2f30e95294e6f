package org.urbi.kernel.variable;

import org.urbi.kernel.job.JobOwner;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;

/**
 * Reads a variable once in each period of the system ({@code System.period}), so that code which
 * computes it on access runs, and subscribers to its changes are notified.
 */
final class AccessLoop {
  private static final double NANOSECONDS = 1e9;
  private static final double SHORTEST_SECONDS = 0.001;

  private final Interpreter interpreter;
  private final UrbiUVar variable;
  private boolean reading;

  AccessLoop(Interpreter interpreter, UrbiUVar variable) {
    this.interpreter = interpreter;
    this.variable = variable;
    next();
  }

  private void next() {
    Scheduler scheduler = interpreter.scheduler();
    scheduler.timers().add(scheduler.now() + period(), this::due);
  }

  private long period() {
    UrbiObject system = interpreter.world().prototype("System");
    double seconds =
        system.lookup(interpreter.world().symbol("period")) instanceof UrbiFloat number
            ? number.value()
            : 0;
    return (long) (Math.max(seconds, SHORTEST_SECONDS) * NANOSECONDS);
  }

  private void due() {
    if (!variable.needsAccess()) {
      variable.accessLoopEnded();
      return;
    }
    next();
    if (reading) {
      return;
    }
    reading = true;
    Scheduler scheduler = interpreter.scheduler();
    UrbiObject lobby = variable.lobby();
    JobOwner.start(
            scheduler,
            lobby,
            "access",
            job -> variable.readInLoop(Frame.top(interpreter, job, lobby, new FrameLayout())))
        .onEnd(() -> reading = false);
  }
}
