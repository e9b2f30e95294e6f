package org.urbi.kernel.library.code;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.event.Durations;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.Profiler;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** The results of {@code System.profile} (manual, "Profile"). */
@UrbiType(
    value = "Profile",
    doc = "What a piece of code has called, and for how long.",
    needs = Permission.NOTHING)
final class ProfileType {
  private ProfileType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiProfile(world.values().object.cloneShape(), null);
  }

  /** Ordered by the time spent, then by the number of calls, highest first. */
  private static List<Profiler.Calls> sorted(UrbiProfile self) {
    if (self.profiler() == null) {
      return List.of();
    }
    List<Profiler.Calls> calls = new ArrayList<>(self.profiler().calls());
    calls.sort(
        Comparator.comparingLong(Profiler.Calls::self)
            .thenComparingLong(Profiler.Calls::count)
            .reversed());
    return calls;
  }

  @Builtin(doc = "The functions called, those that took most time first.")
  static List<UrbiObject> calls(UrbiProfile self) {
    World world = self.world();
    List<UrbiObject> functions = new ArrayList<>();
    for (Profiler.Calls each : sorted(self)) {
      double seconds = Durations.seconds(each.self());
      UrbiObject function = world.prototype("Profile.Function").cloned();
      OwnSlots.put(function, "name", world.values().string(each.name()));
      OwnSlots.put(function, "calls", world.values().number(each.count()));
      OwnSlots.put(function, "selfTime", world.values().number(seconds));
      OwnSlots.put(function, "selfTimePer", world.values().number(seconds / each.count()));
      functions.add(function);
    }
    return functions;
  }

  @Builtin(doc = "How deep calls were nested.")
  static double maxFunctionCallDepth(UrbiProfile self) {
    return self.profiler() == null ? 0 : self.profiler().maximumDepth();
  }

  @Builtin(doc = "How many calls there were.")
  static double totalCalls(UrbiProfile self) {
    return sorted(self).stream().mapToLong(Profiler.Calls::count).sum();
  }

  @Builtin(doc = "How many seconds the functions took.")
  static double totalTime(UrbiProfile self) {
    return Durations.seconds(sorted(self).stream().mapToLong(Profiler.Calls::self).sum());
  }

  @Builtin(doc = "How many seconds there were from the beginning to the end.")
  static double wallClockTime(UrbiProfile self) {
    return self.profiler() == null ? 0 : Durations.seconds(self.profiler().wallClock());
  }

  @Builtin(doc = "How often the code has let others run.")
  static double yields(UrbiProfile self) {
    return self.profiler() == null ? 0 : self.profiler().yields();
  }

  @Builtin(doc = "The profile as a table.")
  static String asString(UrbiProfile self) {
    return self.profiler() == null ? "Profile" : ProfileTable.of(self.profiler(), sorted(self));
  }
}
