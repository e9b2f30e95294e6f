package org.urbi.kernel.library.concurrent;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Limits for the number of jobs in critical sections (manual, "Semaphore"). */
@UrbiType(
    value = "Semaphore",
    doc = "A limit for the number of jobs that use something.",
    needs = Permission.CHANGE)
final class SemaphoreType {
  private SemaphoreType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiSemaphore(world.values().object.cloneShape(), 0);
  }

  @Builtin(doc = "Lets that many jobs in.")
  static void init(Frame frame, CallSite site, UrbiSemaphore self, int places) {
    if (places < 0) {
      UrbiObject given = frame.interpreter().values().number(places);
      throw Arguments.negativeInteger(frame, site, 1, given);
    }
    self.setFree(places);
  }

  @Builtin(
      value = {"acquire", "p"},
      doc = "Enters the critical section, as soon as there is room.")
  static void acquire(Frame frame, CallSite site, UrbiSemaphore self) {
    WaitingCall.note(frame, site);
    self.acquire(frame.job());
  }

  @Builtin(
      value = {"release", "v"},
      doc = "Leaves the critical section.")
  static void release(UrbiSemaphore self) {
    self.release();
  }

  @Builtin(doc = "Calls a function in the critical section.")
  static UrbiObject criticalSection(
      Frame frame, CallSite site, UrbiSemaphore self, UrbiObject code) {
    acquire(frame, site, self);
    try {
      return frame.interpreter().call(frame, site, code, frame.self());
    } finally {
      self.release();
    }
  }
}
