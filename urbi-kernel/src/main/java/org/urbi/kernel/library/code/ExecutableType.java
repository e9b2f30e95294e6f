package org.urbi.kernel.library.code;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.object.UrbiObject;

/** Objects that can be called (manual, "Executable"). */
@UrbiType(
    value = "Executable",
    doc = "What can be called: functions and primitives.",
    needs = Permission.NOTHING)
final class ExecutableType {
  private ExecutableType() {}

  @Builtin(doc = "The target.")
  static UrbiObject asExecutable(UrbiObject self) {
    return self;
  }
}
