package org.urbi.kernel.library.machine;

import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.exception.ExceptionType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;
import org.urbi.kernel.outside.ChildProcess;

/**
 * How a program of the machine is (manual, "Process"): its slots say whether it was {@code
 * started}, is {@code running}, has {@code exited} or was {@code signaled}, and then with which
 * {@code exitStatus} or {@code signal}.
 */
@UrbiType(
    value = "Process.Status",
    doc = "How a program is: not started, running, ended.",
    needs = Permission.NOTHING)
final class ProcessStatusType {
  private ProcessStatusType() {}

  /** The status of a program; null when it was not started. */
  static UrbiObject of(Frame frame, @Nullable ChildProcess program) {
    Values values = frame.interpreter().values();
    UrbiObject status = frame.interpreter().world().prototype("Process.Status").cloned();
    ChildProcess over = program == null || program.isRunning() ? null : program;
    int signal = over == null ? 0 : over.signal();
    add(status, "started", values.bool(program != null));
    add(status, "running", values.bool(program != null && over == null));
    add(status, "exited", values.bool(over != null && signal == 0));
    add(status, "signaled", values.bool(signal != 0));
    add(status, "exitStatus", over == null ? values.nil : values.number(over.exitStatus()));
    add(status, "signal", signal == 0 ? values.nil : values.number(signal));
    return status;
  }

  private static void add(UrbiObject status, String slot, UrbiObject value) {
    status.addSlot(status.world().symbol(slot), value);
  }

  @Builtin(doc = "The status as text: running, exited with status 0…")
  static String asString(Frame frame, UrbiObject self) {
    if (is(frame, self, "running")) {
      return Problem.STATUS_RUNNING.text();
    }
    if (is(frame, self, "exited")) {
      return Problem.STATUS_EXITED.text(ExceptionType.text(frame, self, "exitStatus"));
    }
    if (is(frame, self, "signaled")) {
      return Problem.STATUS_KILLED.text(ExceptionType.text(frame, self, "signal"));
    }
    return Problem.STATUS_NOT_STARTED.text();
  }

  private static boolean is(Frame frame, UrbiObject self, String slot) {
    UrbiObject value = self.lookup(self.world().symbol(slot));
    return value != null && Truth.of(frame, value);
  }
}
