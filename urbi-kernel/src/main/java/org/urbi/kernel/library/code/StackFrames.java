package org.urbi.kernel.library.code;

import java.util.ArrayList;
import java.util.List;
import org.urbi.kernel.error.UrbiException;
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
   * unless {@code Traceable} shows them.
   */
  public UrbiObject list(World world, List<UrbiException.Call> calls) {
    List<UrbiObject> frames = new ArrayList<>();
    UrbiObject prototype = world.prototype("StackFrame");
    boolean hides = TraceableType.hidesSystemFiles(world);
    for (UrbiException.Call call : calls) {
      if (call.name() != null
          && call.span() != null
          && !(hides && files.isSystemFile(call.span().location().file()))) {
        UrbiObject frame = prototype.cloned();
        StackFrameType.fill(
            frame, world.values().string(call.name()), LocationType.make(world, call.span()));
        frames.add(frame);
      }
    }
    return world.values().list(frames);
  }
}
