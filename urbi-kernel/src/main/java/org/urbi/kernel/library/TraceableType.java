package org.urbi.kernel.library;

import java.util.List;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Objects with a backtrace (manual, "Traceable"). */
@UrbiType(value = "Traceable", doc = "What has a backtrace.")
final class TraceableType {
  private TraceableType() {}

  static UrbiObject newPrototype(World world) {
    UrbiObject prototype = world.values().object.cloned();
    prototype.addSlot(world.symbol("hideSystemFiles"), world.values().trueObject);
    prototype.addSlot(world.symbol("backtrace"), world.values().list(List.of()));
    return prototype;
  }
}
