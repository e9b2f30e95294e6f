package org.urbi.kernel.library;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Variables that can be hooked (manual, "UVar"). */
@UrbiType(value = "UVar", doc = "A variable whose changes and accesses can be hooked.")
final class UVarType {
  private UVarType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiUVar(world.values().object.cloneShape());
  }

  @Builtin(doc = "Stands behind the slot of that name of an object.")
  static void init(Frame frame, UrbiUVar self, UrbiObject owner, String name) {
    self.bind(frame, owner, self.world().symbol(name));
  }

  @Builtin(doc = "Stands behind a slot of another object, too.")
  static void copy(Frame frame, UrbiUVar self, UrbiObject owner, String name) {
    self.bind(frame, owner, self.world().symbol(name));
  }

  @Builtin(doc = "Calls a function at each change; returns a handle to remove it.")
  static double notifyChange(UrbiUVar self, UrbiObject onChange) {
    return self.notifyChange(onChange);
  }

  @Builtin(doc = "As notifyChange, for commands to a variable that has a sensed value as well.")
  static double notifyChangeOwned(UrbiUVar self, UrbiObject onChangeOwned) {
    return self.notifyChangeOwned(onChangeOwned);
  }

  @Builtin(doc = "Calls a function at each access; returns a handle to remove it.")
  static double notifyAccess(UrbiUVar self, UrbiObject onAccess) {
    return self.notifyAccess(onAccess);
  }

  @Builtin(
      value = {"removeNotifyChange", "removeNotifyChangeOwned"},
      doc = "Removes a function that notifyChange has installed.")
  static boolean removeNotifyChange(UrbiUVar self, double handle) {
    return self.removeChange((long) handle);
  }

  @Builtin(doc = "Removes a function that notifyAccess has installed.")
  static boolean removeNotifyAccess(UrbiUVar self, double handle) {
    return self.removeAccess((long) handle);
  }

  @Builtin(doc = "Whether it has both a sensed and a commanded value.")
  static boolean owned(UrbiUVar self) {
    return self.isOwned();
  }
}
