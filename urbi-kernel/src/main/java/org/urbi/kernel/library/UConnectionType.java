package org.urbi.kernel.library;

import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import org.urbi.kernel.uobject.PluggedContext;
import org.urbi.kernel.variable.UrbiConnection;
import org.urbi.kernel.variable.UrbiUVar;

/** Links between variables (manual, "Customizing data-flow links"). */
@UrbiType(value = "UConnection", doc = "Leads each new value of one variable to another.")
final class UConnectionType {
  private static final double NANOSECONDS = 1e9;

  private UConnectionType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiConnection(world.values().object.cloneShape());
  }

  @Builtin(doc = "Leads the values of a variable to another.")
  static void init(Frame frame, UrbiConnection self, UrbiUVar source, UrbiUVar target) {
    self.connect(frame, source, target);
    PluggedContext.of(frame).connections().add(self);
  }

  @Builtin(doc = "Whether values are led.")
  static boolean enabled(UrbiConnection self) {
    return self.isEnabled();
  }

  @Builtin(value = "enabled", setter = true, doc = "Disables or enables the link.")
  static void assignEnabled(Frame frame, UrbiConnection self, UrbiObject on) {
    self.setEnabled(Truth.of(frame, on));
  }

  @Builtin(doc = "Seconds that pass between two values at least; what comes earlier is dropped.")
  static double minInterval(UrbiConnection self) {
    return self.minInterval() / NANOSECONDS;
  }

  @Builtin(value = "minInterval", setter = true, doc = "Limits the rate of the link.")
  static void assignMinInterval(UrbiConnection self, double seconds) {
    self.setMinInterval(Math.round(seconds * NANOSECONDS));
  }

  @Builtin(doc = "Whether values are led in a job of their own, one at a time.")
  static boolean asynchronous(UrbiConnection self) {
    return self.isAsynchronous();
  }

  @Builtin(
      value = "asynchronous",
      setter = true,
      doc = "Has values led in a job of their own; what comes while it runs is dropped.")
  static void assignAsynchronous(Frame frame, UrbiConnection self, UrbiObject on) {
    self.setAsynchronous(Truth.of(frame, on));
  }

  @Builtin(doc = "Ends the link.")
  static void disconnect(Frame frame, UrbiConnection self) {
    self.disconnect();
    PluggedContext.of(frame).connections().remove(self);
  }

  @Builtin(doc = "Has the link begin at another variable.")
  static void reconnect(Frame frame, UrbiConnection self, UrbiUVar src) {
    if (self.target() == null) {
      throw frame.interpreter().errors().primitive("reconnect", "the link has no target");
    }
    init(frame, self, src, self.target());
  }

  // ------------------------------------------------------------------ statistics

  @Builtin(doc = "How many values have been led.")
  static double callCount(UrbiConnection self) {
    return self.times().count();
  }

  @Builtin(doc = "How many values a second have been led.")
  static double fireRate(UrbiConnection self) {
    return self.fireRate();
  }

  @Builtin(
      doc =
          "How many seconds the functions of the target took on average; measured once a tick, as"
              + " the next two are.")
  static double meanCallTime(UrbiConnection self) {
    return self.times().mean();
  }

  @Builtin(doc = "How many seconds the functions of the target took at least.")
  static double minCallTime(UrbiConnection self) {
    return self.times().least();
  }

  @Builtin(doc = "How many seconds the functions of the target took at most.")
  static double maxCallTime(UrbiConnection self) {
    return self.times().most();
  }

  @Builtin(doc = "Forgets the statistics.")
  static void resetStats(UrbiConnection self) {
    self.times().reset();
  }

  @Builtin(doc = "All the links there are.")
  static List<UrbiConnection> getAll(Frame frame, UrbiObject self) {
    return PluggedContext.of(frame).connections().all();
  }

  @Builtin(doc = "Where it begins and ends, to be shown.")
  static String asString(UrbiConnection self) {
    if (self.source() == null) {
      return "UConnection";
    }
    return self.source().name() + " >> " + self.target().name();
  }
}
