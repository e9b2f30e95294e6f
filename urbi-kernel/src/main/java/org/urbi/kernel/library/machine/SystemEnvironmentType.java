package org.urbi.kernel.library.machine;

import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.library.system.KernelControl;
import org.urbi.kernel.library.text.NativeText;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;

/** The variables of the environment as a container: what {@code getenv} and its like do. */
@UrbiType(
    value = "System.env",
    protos = {"Singleton"},
    doc = "The variables of the environment.")
final class SystemEnvironmentType {
  private SystemEnvironmentType() {}

  @Builtin(value = "[]", doc = "The value of a variable; nil if it is not set.")
  static UrbiObject at(Frame frame, UrbiObject self, String name) {
    return SystemEnvironment.getenv(frame, self, name);
  }

  @Builtin(value = "[]=", doc = "Sets a variable, and returns its value.")
  static String set(Frame frame, CallSite site, UrbiObject self, String name, UrbiObject value) {
    return SystemEnvironment.setenv(frame, site, self, name, value);
  }

  @Builtin(doc = "Whether a variable is set.")
  static boolean has(Frame frame, UrbiObject self, String name) {
    return KernelControl.of(frame).environment().get(NativeText.toJava(name)) != null;
  }

  @Builtin(doc = "Removes a variable.")
  static UrbiObject erase(Frame frame, UrbiObject self, String name) {
    SystemEnvironment.unsetenv(frame, self, name);
    return self;
  }

  @Builtin(doc = "The names of all variables.")
  static List<UrbiString> keys(Frame frame, UrbiObject self) {
    return KernelControl.of(frame).environment().variables().keySet().stream()
        .map(name -> frame.interpreter().values().string(NativeText.toUrbi(name)))
        .toList();
  }

  @Builtin(doc = "The number of variables.")
  static double size(Frame frame, UrbiObject self) {
    return KernelControl.of(frame).environment().variables().size();
  }
}
