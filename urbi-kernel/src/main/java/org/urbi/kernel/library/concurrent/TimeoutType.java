package org.urbi.kernel.library.concurrent;

import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.event.Durations;
import org.urbi.kernel.library.object.ObjectType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Tags for code in limited time (manual, "Timeout"). */
@UrbiType(
    value = "Timeout",
    protos = {"Tag"},
    doc = "A tag for code that has limited time.",
    needs = Permission.NOTHING)
final class TimeoutType {
  private TimeoutType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiTimeout(world.values().object.cloneShape());
  }

  @Builtin(
      doc = "For code that has so many seconds; whether to throw when they are over.",
      needs = Permission.CHANGE)
  static void init(
      Frame frame, UrbiTimeout self, double duration, @Optional @Nullable UrbiObject throwing) {
    self.set(Durations.nanoseconds(duration), throwing == null || Truth.of(frame, throwing));
  }

  @Builtin(doc = "Begins to count down.", needs = Permission.CHANGE)
  static void launch(Frame frame, UrbiTimeout self) {
    self.launch(frame);
  }

  @Builtin(doc = "Whether the time was over before the code was.")
  static boolean timedOut(UrbiTimeout self) {
    return self.timedOut();
  }

  @Builtin(doc = "The timeout itself.")
  static UrbiObject asTimeout(UrbiTimeout self) {
    return self;
  }

  @Builtin(doc = "The timeout as text.")
  static String asString(Frame frame, UrbiTimeout self) {
    return ObjectType.asString(frame, self);
  }
}
