package org.urbi.kernel.library.date;

import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import org.urbi.lang.print.FloatFormat;

/** Differences of dates (manual, "Duration"). */
@UrbiType(
    value = "Duration",
    protos = "Float",
    doc = "A number of seconds between two dates.",
    needs = Permission.NOTHING)
final class DurationType {
  private DurationType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiFloat(world.values().floatProto.cloneShape(), 0);
  }

  /** A new duration, in seconds. */
  static UrbiFloat duration(Frame caller, double seconds) {
    return new UrbiFloat(caller.interpreter().world().prototype("Duration").cloneShape(), seconds);
  }

  @Builtin(value = "new", doc = "A duration of so many seconds; of none without an argument.")
  static UrbiObject make(UrbiFloat self, @Optional @Nullable Double seconds) {
    return new UrbiFloat(self.cloneShape(), seconds == null ? self.value() : seconds);
  }

  @Builtin(
      value = {"asFloat", "seconds"},
      doc = "The number of seconds.")
  static double seconds(UrbiFloat self) {
    return self.value();
  }

  @Builtin(doc = "The number of seconds, and its unit.")
  static String asString(UrbiFloat self) {
    return FloatFormat.format(self.value()) + "s";
  }

  @Builtin(doc = "The duration, to be shown.")
  static String asPrintable(UrbiFloat self) {
    return "Duration(" + FloatFormat.format(self.value()) + "s)";
  }
}
