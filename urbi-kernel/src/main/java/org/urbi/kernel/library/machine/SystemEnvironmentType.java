package org.urbi.kernel.library.machine;

import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.Utf8Text;

/** The variables of the environment as a container: what {@code getenv} and its like do. */
@UrbiType(
    value = "System.env",
    protos = {"Singleton"},
    doc = "The variables of the environment.",
    needs = Permission.OWNER)
final class SystemEnvironmentType {
  private final Environment environment;
  private final SystemEnvironment functions;

  SystemEnvironmentType(Environment environment) {
    this.environment = environment;
    this.functions = new SystemEnvironment(environment);
  }

  @Builtin(value = "[]", doc = "The value of a variable; nil if it is not set.")
  UrbiObject at(Frame frame, UrbiObject self, String name) {
    return functions.getenv(frame, self, name);
  }

  @Builtin(value = "[]=", doc = "Sets a variable, and returns its value.")
  String set(Frame frame, CallSite site, UrbiObject self, String name, UrbiObject value) {
    return functions.setenv(frame, site, self, name, value);
  }

  @Builtin(doc = "Whether a variable is set.")
  boolean has(Frame frame, UrbiObject self, String name) {
    return environment.get(Utf8Text.toJava(name)) != null;
  }

  @Builtin(doc = "Removes a variable.")
  UrbiObject erase(Frame frame, UrbiObject self, String name) {
    functions.unsetenv(frame, self, name);
    return self;
  }

  @Builtin(doc = "The names of all variables.")
  List<UrbiString> keys(Frame frame, UrbiObject self) {
    return environment.variables().keySet().stream()
        .map(name -> frame.interpreter().values().string(Utf8Text.toUrbi(name)))
        .toList();
  }

  @Builtin(doc = "The number of variables.")
  double size(Frame frame, UrbiObject self) {
    return environment.variables().size();
  }
}
