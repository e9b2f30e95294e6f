package org.urbi.kernel.library.uobject;

import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.file.FileAccess;
import org.urbi.kernel.library.file.UrbiPath;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import org.urbi.kernel.uobject.PluggedContext;

/** Objects with code behind them that is not urbiscript (manual, "UObject"). */
@UrbiType(value = "UObject", doc = "An object with Java code behind it.", needs = Permission.USER)
final class UObjectType {
  private final PluggedContext uobjects;

  UObjectType(PluggedContext uobjects) {
    this.uobjects = uobjects;
  }

  static UrbiObject newPrototype(World world) {
    UrbiObject prototype = world.values().object.cloned();
    prototype.addSlot(world.symbol("load"), world.values().number(1));
    return prototype;
  }

  @Builtin(
      value = "new",
      doc = "A clone with Java code of its own, initialized by its init with these arguments.")
  UrbiObject newOf(Frame frame, CallSite site, UrbiObject self, UrbiObject... arguments) {
    return uobjects.creation().make(frame, site, self, arguments);
  }

  @Builtin(doc = "Ends the Java code behind the object.", needs = Permission.CHANGE)
  void destroy(Frame frame, CallSite site, UrbiObject self) {
    if (!uobjects.creation().destroy(frame, self)) {
      throw frame.error(site, Problem.NOT_A_UOBJECT);
    }
  }

  @Builtin(doc = "The folders where modules are looked for.")
  List<UrbiObject> searchPath(Frame frame, UrbiObject self) {
    return uobjects.modules().searchPath().stream()
        .map(folder -> (UrbiObject) FileAccess.anyPath(frame).sibling(UrbiPath.encoded(folder)))
        .toList();
  }
}
