package org.urbi.kernel.library.code;

import java.util.List;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.Elements;
import org.urbi.kernel.object.SlotNames;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Calls that are going on, or were, as urbiscript sees them (manual, "StackFrame"). */
public final class StackFrames {
  private final World world;
  private final Locations locations;
  private final SlotNames slots;
  private final LoadedFiles files;

  public StackFrames(World world, LoadedFiles files) {
    this.world = world;
    this.locations = new Locations(world);
    this.slots = new SlotNames(world.symbol("name"), world.symbol("location"));
    this.files = files;
  }

  /**
   * The calls as a list, without calls made by Java code of the library, nor by its source files
   * unless {@code Traceable} shows them. Its elements are made when somebody looks at them: most
   * exceptions are caught and forgotten.
   */
  public UrbiObject list(List<UrbiException.Call> calls) {
    boolean hides = TraceableType.hidesSystemFiles(world);
    return world.values().listLater(() -> frames(calls, hides));
  }

  /** Makes locations. */
  public Locations locations() {
    return locations;
  }

  private Elements frames(List<UrbiException.Call> calls, boolean hides) {
    Elements frames = new Elements(calls.size());
    UrbiObject prototype = world.prototype("StackFrame");
    for (UrbiException.Call call : calls) {
      if (call.name() != null && call.span() != null && !(hides && files.isOfSystem(call.span()))) {
        frames.add(
            prototype.clonedWith(
                slots, world.values().string(call.name()), locations.location(call.span())));
      }
    }
    return frames;
  }
}
