package org.urbi.kernel.library.code;

import java.util.List;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.Elements;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Calls that are going on, or were, as urbiscript sees them (manual, "StackFrame"). */
public final class StackFrames {
  private final LoadedFiles files;

  public StackFrames(LoadedFiles files) {
    this.files = files;
  }

  /**
   * The calls as a list, without calls made by Java code of the library, nor by its source files
   * unless {@code Traceable} shows them. Its elements are made when somebody looks at them: most
   * exceptions are caught and forgotten.
   */
  public UrbiObject list(World world, List<UrbiException.Call> calls) {
    boolean hides = TraceableType.hidesSystemFiles(world);
    return world.values().listLater(() -> frames(world, calls, hides));
  }

  private Elements frames(World world, List<UrbiException.Call> calls, boolean hides) {
    Elements frames = new Elements(calls.size());
    UrbiObject prototype = world.prototype("StackFrame");
    Symbol[] slots = {world.symbol("name"), world.symbol("location")};
    for (UrbiException.Call call : calls) {
      if (call.name() != null
          && call.span() != null
          && !(hides && files.isSystemFile(call.span().location().file()))) {
        frames.add(
            prototype.clonedWith(
                slots, world.values().string(call.name()), LocationType.make(world, call.span())));
      }
    }
    return frames;
  }
}
