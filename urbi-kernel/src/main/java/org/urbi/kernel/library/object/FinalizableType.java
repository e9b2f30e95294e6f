package org.urbi.kernel.library.object;

import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import org.urbi.kernel.outside.Outside;
import org.urbi.kernel.time.SystemClock;

/** Objects that do something when they are reclaimed (manual, "Finalizable"). */
@UrbiType(
    value = "Finalizable",
    doc = "An object whose method finalize is called when nobody refers to it any more.",
    needs = Permission.NOTHING)
final class FinalizableType {
  private final Outside outside;

  FinalizableType(Outside outside) {
    this.outside = outside;
  }

  UrbiObject newPrototype(World world) {
    Scheduler scheduler = outside.scheduler();
    return UrbiFinalizable.prototype(
        world.values().object.cloneShape(),
        new Finalization(
            scheduler.journal(), new RunningJob(scheduler), System::gc, new SystemClock()));
  }

  /** What no job has made belongs to the system. */
  private record RunningJob(Scheduler scheduler) implements Finalization.Running {
    @Override
    public boolean isOwner() {
      Job job = scheduler.running();
      return job == null || job.isOwner();
    }

    @Override
    public @Nullable UrbiObject lobby() {
      Job job = scheduler.running();
      return job == null ? null : job.lobby();
    }

    /** In simulated time nobody waits in vain. */
    @Override
    public boolean isAlone() {
      UrbiObject lobby = lobby();
      return !scheduler.clock().isReal()
          || !scheduler.hasJob(job -> job.lobby() != lobby && !job.isDaemon());
    }
  }

  @Builtin(doc = "Called when nobody refers to the object any more; does nothing.")
  void finalize(UrbiObject self) {}

  /** Refuses a prototype that would make an object finalizable which was not made so. */
  static void check(Frame frame, String routine, UrbiObject self, UrbiObject proto) {
    UrbiObject finalizable = self.world().prototype("Finalizable");
    if (!(self instanceof UrbiFinalizable) && proto.isA(finalizable)) {
      throw frame.interpreter().errors().finalizable(routine == null ? "updateSlot" : routine);
    }
  }
}
