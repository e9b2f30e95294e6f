package org.urbi.kernel.library.uobject;

import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.event.Durations;
import org.urbi.kernel.event.FunctionHandler;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.event.UrbiSubscription;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import org.urbi.kernel.uobject.PluggedContext;
import org.urbi.kernel.variable.UrbiConnection;

/**
 * The settings of a subscription to an event or to a variable (manual, "Customizing data-flow
 * links"; Urbi 3, "Subscription").
 */
@UrbiType(
    value = "Subscription",
    doc = "Somebody who listens to an event or to a variable, and on which terms.",
    needs = Permission.NOTHING)
final class SubscriptionType {
  private static final double NANOSECONDS = 1e9;

  private final PluggedContext uobjects;

  SubscriptionType(PluggedContext uobjects) {
    this.uobjects = uobjects;
  }

  static UrbiObject newPrototype(World world) {
    return new UrbiSubscription(world.values().object.cloneShape());
  }

  @Builtin(
      doc = "Calls a function with what is sent with an event, once it is subscribed to one.",
      needs = Permission.CHANGE)
  static void init(UrbiSubscription self, UrbiObject function) {
    self.setListener((frame, event) -> FunctionHandler.plain(frame, event, function));
  }

  @Builtin(doc = "Whether there are calls.")
  static boolean enabled(UrbiSubscription self) {
    return self.gate().isEnabled();
  }

  @Builtin(
      value = "enabled",
      setter = true,
      doc = "Disables or enables the calls.",
      needs = Permission.CHANGE)
  static void assignEnabled(Frame frame, UrbiSubscription self, UrbiObject on) {
    self.gate().setEnabled(Truth.of(frame, on));
  }

  @Builtin(doc = "Seconds that pass between two calls at least; what comes earlier is dropped.")
  static double minInterval(UrbiSubscription self) {
    return self.gate().minInterval() / NANOSECONDS;
  }

  @Builtin(
      value = "minInterval",
      setter = true,
      doc = "Limits the rate of the calls.",
      needs = Permission.CHANGE)
  static void assignMinInterval(UrbiSubscription self, double seconds) {
    self.gate().setMinInterval(Durations.nanoseconds(seconds));
  }

  @Builtin(doc = "Whether calls are made in a job of their own, one at a time.")
  static boolean asynchronous(UrbiSubscription self) {
    return self.gate().isAsynchronous();
  }

  @Builtin(
      value = "asynchronous",
      setter = true,
      doc = "Has calls made in a job of their own; what comes while it runs is dropped.",
      needs = Permission.CHANGE)
  static void assignAsynchronous(Frame frame, UrbiSubscription self, UrbiObject on) {
    self.gate().setAsynchronous(Truth.of(frame, on));
  }

  @Builtin(doc = "Ends it.", needs = Permission.CHANGE)
  static void disconnect(UrbiSubscription self) {
    self.disconnect();
  }

  @Builtin(doc = "Has it listen to another event.", needs = Permission.CHANGE)
  static void reconnect(Frame frame, UrbiSubscription self, UrbiEvent src) {
    if (!self.canListen()) {
      throw frame
          .interpreter()
          .errors()
          .primitive("reconnect", Problem.SUBSCRIPTION_WITHOUT_FUNCTION);
    }
    self.listenTo(frame, src);
  }

  // ------------------------------------------------------------------ statistics

  @Builtin(doc = "How many calls there were.")
  static double callCount(UrbiSubscription self) {
    return self.gate().times().count();
  }

  @Builtin(doc = "How many calls a second there were.")
  static double fireRate(UrbiSubscription self) {
    return self.gate().fireRate();
  }

  @Builtin(doc = "How many seconds the calls took on average; measured once a tick.")
  static double meanCallTime(UrbiSubscription self) {
    return self.gate().times().mean();
  }

  @Builtin(doc = "How many seconds the calls took at least.")
  static double minCallTime(UrbiSubscription self) {
    return self.gate().times().least();
  }

  @Builtin(doc = "How many seconds the calls took at most.")
  static double maxCallTime(UrbiSubscription self) {
    return self.gate().times().most();
  }

  @Builtin(doc = "Forgets the statistics.", needs = Permission.CHANGE)
  static void resetStats(UrbiSubscription self) {
    self.gate().times().reset();
  }

  @Builtin(doc = "All the links between variables.")
  List<UrbiConnection> getAll(Frame frame, UrbiObject self) {
    return uobjects.connections().all();
  }
}
