package org.urbi.kernel.library.code;

import java.util.ArrayList;
import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.library.system.KernelControl;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.World;

/** Calls that are going on (manual, "StackFrame"). */
@UrbiType(value = "StackFrame", doc = "A call: what was called, and where.")
public final class StackFrameType {
  private StackFrameType() {}

  /**
   * The calls as a list, without those which were made by the library itself in Java, and, unless
   * {@code Traceable} says otherwise, by its source files.
   */
  public static UrbiObject list(Interpreter interpreter, List<UrbiException.Call> calls) {
    World world = interpreter.world();
    List<UrbiObject> frames = new ArrayList<>();
    UrbiObject prototype = world.prototype("StackFrame");
    LoadedFiles files = ((KernelControl) interpreter.host()).loadedFiles();
    boolean hides = TraceableType.hidesSystemFiles(world);
    for (UrbiException.Call call : calls) {
      if (call.name() != null
          && call.span() != null
          && !(hides && files.isSystemFile(call.span().location().file()))) {
        UrbiObject frame = prototype.cloned();
        fill(frame, world.values().string(call.name()), LocationType.make(world, call.span()));
        frames.add(frame);
      }
    }
    return world.values().list(frames);
  }

  private static void fill(UrbiObject self, UrbiObject name, UrbiObject location) {
    OwnSlots.put(self, "name", name);
    OwnSlots.put(self, "location", location);
  }

  @Builtin(doc = "A call of the function of that name at that location.")
  static void init(UrbiObject self, UrbiString name, UrbiObject location) {
    fill(self, name, location);
  }

  @Builtin(doc = "The location and the name.")
  static String asString(Frame frame, UrbiObject self) {
    if (self == self.world().prototype("StackFrame")) {
      return "StackFrame";
    }
    return frame.interpreter().asString(frame, OwnSlots.get(frame, self, "location"))
        + ": "
        + frame.interpreter().asString(frame, OwnSlots.get(frame, self, "name"));
  }
}
