package org.urbi.kernel.library.object;

import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Objects that can be switched on and off (manual, "Loadable"). */
@UrbiType(value = "Loadable", doc = "What can be switched on and off.", needs = Permission.CHANGE)
final class LoadableType {
  private LoadableType() {}

  static UrbiObject newPrototype(World world) {
    UrbiObject prototype = world.values().object.cloned();
    prototype.addSlot(world.symbol("load"), world.values().falseObject);
    return prototype;
  }

  private static UrbiObject set(Frame frame, UrbiObject self, boolean load) {
    OwnSlots.set(frame, self, "load", self.world().values().bool(load));
    return self;
  }

  @Builtin(doc = "Switches the target on, and returns it.")
  static UrbiObject on(Frame frame, UrbiObject self, @Optional @Nullable UrbiObject val) {
    return set(frame, self, true);
  }

  @Builtin(doc = "Switches the target off, and returns it.")
  static UrbiObject off(Frame frame, UrbiObject self, @Optional @Nullable UrbiObject val) {
    return set(frame, self, false);
  }

  @Builtin(doc = "Switches the target on if it is off, off if it is on, and returns it.")
  static UrbiObject toggle(Frame frame, UrbiObject self, @Optional @Nullable UrbiObject val) {
    return set(frame, self, !Truth.of(frame, OwnSlots.get(frame, self, "load")));
  }
}
