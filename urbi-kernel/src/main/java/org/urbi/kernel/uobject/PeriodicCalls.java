package org.urbi.kernel.uobject;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import urbi.UCallback;
import urbi.UObject;

/** The periodic calls, by the objects and hubs that own them. */
final class PeriodicCalls {
  private static final double NANOSECONDS = 1e9;
  private static final double NANOSECONDS_PER_MILLISECOND = 1e6;
  private static final double SHORTEST_SECONDS = 0.001;

  private final PluggedContext context;
  private final Map<Object, List<PeriodicCall>> calls = new IdentityHashMap<>();

  PeriodicCalls(PluggedContext context) {
    this.context = context;
  }

  /** Calls a function periodically from now on. */
  PeriodicCall begin(
      Frame frame, Object owner, double milliseconds, UCallback function, boolean afterPass) {
    Instance instance = instance(owner);
    UrbiObject maker = instance == null ? null : instance.lobby();
    UrbiObject lobby = maker == null ? context.lobby() : maker;
    PeriodicCall call = new PeriodicCall(context, lobby, function, milliseconds, afterPass);
    calls.computeIfAbsent(owner, key -> new ArrayList<>()).add(call);
    keep(instance, true);
    call.begin();
    return call;
  }

  private @Nullable Instance instance(Object owner) {
    return owner instanceof UObject object ? context.objects().named(object.get__name()) : null;
  }

  /** An object with a periodic call is kept alive, even if nobody refers to it. */
  private static void keep(@Nullable Instance instance, boolean alive) {
    if (instance != null) {
      instance.keepAlive(alive);
    }
  }

  /** Ends one. */
  void end(Object owner, PeriodicCall call) {
    call.end();
    List<PeriodicCall> all = calls.get(owner);
    if (all != null && all.remove(call) && all.isEmpty()) {
      calls.remove(owner);
      keep(instance(owner), false);
    }
  }

  /** Ends all calls of an object or hub. */
  void end(Object owner) {
    List<PeriodicCall> all = calls.remove(owner);
    if (all != null) {
      all.forEach(PeriodicCall::end);
    }
  }

  /** Converts a period to nanoseconds; it is not shorter than that of the system. */
  long period(double milliseconds) {
    World world = context.interpreter().world();
    double seconds =
        world.prototype("System").lookup(world.symbol("period")) instanceof UrbiFloat number
            ? number.value()
            : 0;
    double shortest = Math.max(seconds, SHORTEST_SECONDS) * NANOSECONDS;
    return (long) Math.max(shortest, milliseconds * NANOSECONDS_PER_MILLISECOND);
  }
}
