package org.urbi.kernel.library.concurrent;

import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;

/** Values published to subscribers (manual, "PubSub"). */
@UrbiType(
    value = "PubSub",
    doc = "Values that are published, and queued for each subscriber.",
    needs = Permission.NOTHING)
final class PubSubType {
  private PubSubType() {}

  @Builtin(doc = "Without any subscriber.", needs = Permission.CHANGE)
  static void init(Frame frame, UrbiObject self) {
    UrbiList none = self.world().values().list(List.of());
    PermissionCheck.claimForObserver(frame, none);
    OwnSlots.put(self, "subscribers", none);
  }

  private static UrbiList subscribers(Frame frame, UrbiObject self) {
    UrbiObject all = OwnSlots.get(frame, self, "subscribers");
    if (all instanceof UrbiList list) {
      return list;
    }
    throw frame.interpreter().errors().type(all, self.world().prototype("List"));
  }

  @Builtin(doc = "Queues a value for each subscriber, and returns it.", needs = Permission.CHANGE)
  static UrbiObject publish(Frame frame, UrbiObject self, UrbiObject ev) {
    for (UrbiObject each : List.copyOf(subscribers(frame, self).elements())) {
      if (each instanceof UrbiSubscriber subscriber) {
        subscriber.enqueue(ev);
      }
    }
    return ev;
  }

  /** The subscribers, to be changed: an object may have inherited those of another one. */
  private static UrbiList changeable(Frame frame, String routine, UrbiObject self) {
    UrbiList all = subscribers(frame, self);
    PermissionCheck.checkChange(frame, routine, all);
    return all;
  }

  @Builtin(
      doc = "A new subscriber, for whom values are queued from now on.",
      needs = Permission.CHANGE)
  static UrbiObject subscribe(Frame frame, UrbiObject self) {
    UrbiList all = changeable(frame, "subscribe", self);
    UrbiObject subscriber = self.world().prototype("PubSub.Subscriber").cloned();
    PermissionCheck.claimForObserver(frame, subscriber);
    all.modify().add(subscriber);
    all.noteContentChange();
    return subscriber;
  }

  @Builtin(doc = "Queues nothing more for that subscriber.", needs = Permission.CHANGE)
  static void unsubscribe(Frame frame, UrbiObject self, UrbiObject sub) {
    UrbiList all = changeable(frame, "unsubscribe", self);
    all.modify().removeIf(each -> each == sub);
    all.noteContentChange();
  }
}
