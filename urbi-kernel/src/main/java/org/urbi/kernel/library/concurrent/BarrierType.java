package org.urbi.kernel.library.concurrent;

import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Where jobs wait for others to signal them (manual, "Barrier"). */
@UrbiType(
    value = "Barrier",
    doc = "Where jobs wait until others signal them.",
    needs = Permission.NOTHING)
final class BarrierType {
  private BarrierType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiBarrier(world.values().object.cloneShape());
  }

  private static UrbiObject payload(Frame frame, @Nullable UrbiObject given) {
    return given == null ? frame.interpreter().values().voidObject : given;
  }

  @Builtin(doc = "Waits for a signal, and returns what was sent with it.")
  static UrbiObject wait(Frame frame, CallSite site, UrbiBarrier self) {
    WaitingCall.note(frame, site);
    return self.await(frame.job());
  }

  @Builtin(
      doc = "Wakes the job that has waited longest; the number of jobs woken.",
      needs = Permission.CHANGE)
  static double signal(Frame frame, UrbiBarrier self, @Optional @Nullable UrbiObject payload) {
    return self.signal(payload(frame, payload)) ? 1 : 0;
  }

  @Builtin(
      doc = "Wakes all the jobs that wait; the number of jobs woken.",
      needs = Permission.CHANGE)
  static double signalAll(Frame frame, UrbiBarrier self, @Optional @Nullable UrbiObject payload) {
    int woken = 0;
    while (self.signal(payload(frame, payload))) {
      woken++;
    }
    return woken;
  }
}
