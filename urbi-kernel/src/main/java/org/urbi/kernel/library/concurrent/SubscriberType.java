package org.urbi.kernel.library.concurrent;

import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Who reads what is published (manual, "PubSub.Subscriber"). */
@UrbiType(
    value = "PubSub.Subscriber",
    doc = "Who reads the values that are published.",
    needs = Permission.NOTHING)
final class SubscriberType {
  private SubscriberType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiSubscriber(world.values().object.cloneShape());
  }

  @Builtin(
      doc = "The oldest value in the queue; waits for one if there is none.",
      needs = Permission.CHANGE)
  static UrbiObject getOne(Frame frame, CallSite site, UrbiSubscriber self) {
    WaitingCall.note(frame, site);
    self.awaitValue(frame.job());
    return self.poll();
  }

  @Builtin(
      doc = "All the values in the queue; waits for one if there is none.",
      needs = Permission.CHANGE)
  static List<UrbiObject> getAll(Frame frame, CallSite site, UrbiSubscriber self) {
    WaitingCall.note(frame, site);
    self.awaitValue(frame.job());
    return self.pollAll();
  }

  @Builtin(doc = "Puts a value into the queue.", needs = Permission.CHANGE)
  static void enqueue(UrbiSubscriber self, UrbiObject ev) {
    self.enqueue(ev);
  }
}
