package org.urbi.kernel.library.code;

import java.util.List;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Objects with a backtrace (manual, "Traceable"). */
@UrbiType(value = "Traceable", doc = "What has a backtrace.", needs = Permission.NOTHING)
final class TraceableType {
  private static final String HIDE = "hideSystemFiles";

  private TraceableType() {}

  static UrbiObject newPrototype(World world) {
    UrbiObject prototype = world.values().object.cloned();
    prototype.addSlot(world.symbol(HIDE), world.values().trueObject);
    prototype.addSlot(world.symbol("backtrace"), world.values().list(List.of()));
    return prototype;
  }

  /** Whether calls made in the source files of the library do not belong into a backtrace. */
  static boolean hidesSystemFiles(World world) {
    UrbiObject hide = world.prototype("Traceable").lookup(world.symbol(HIDE));
    return hide != null && Truth.of(hide, world.values());
  }
}
