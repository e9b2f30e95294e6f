package org.urbi.kernel.library.concurrent;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.library.object.ObjectType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Tags for critical sections (manual, "Mutex"). */
@UrbiType(
    value = "Mutex",
    protos = {"Tag"},
    doc = "A tag for critical sections: one job at a time runs under it.",
    needs = Permission.NOTHING)
final class MutexType {
  private MutexType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiMutex(world.values().object.cloneShape());
  }

  @Builtin(doc = "Without arguments.", needs = Permission.CHANGE)
  static void init(UrbiMutex self) {}

  @Builtin(doc = "The mutex itself.")
  static UrbiObject asMutex(UrbiMutex self) {
    return self;
  }

  @Builtin(doc = "The mutex as text.")
  static String asString(Frame frame, UrbiMutex self) {
    return ObjectType.asString(frame, self);
  }

  @Builtin(doc = "Enters the critical section, until unlock.", needs = Permission.CHANGE)
  static void lock(Frame frame, CallSite site, UrbiMutex self) {
    WaitingCall.note(frame, site);
    self.entering(frame);
  }

  @Builtin(doc = "Leaves the critical section that lock has entered.", needs = Permission.CHANGE)
  static void unlock(Frame frame, UrbiMutex self) {
    self.left(frame);
  }
}
