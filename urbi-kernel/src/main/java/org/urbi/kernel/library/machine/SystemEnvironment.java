package org.urbi.kernel.library.machine;

import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;

/** Variables of the environment (manual, "System": getenv, setenv, unsetenv). */
@UrbiTypePart(value = "System", needs = Permission.OWNER)
final class SystemEnvironment {
  private final Environment environment;

  SystemEnvironment(Environment environment) {
    this.environment = environment;
  }

  /** The name of a variable, as the machine wants it. */
  static String name(Frame frame, CallSite site, String name) {
    if (name.isEmpty() || name.indexOf('=') >= 0 || name.indexOf('\0') >= 0) {
      throw frame.error(site, Problem.VARIABLE_NAME, name);
    }
    return Utf8Text.toJava(name);
  }

  /** A variable of the machine as a value of urbiscript. */
  static UrbiObject value(Frame frame, @Nullable String value) {
    var values = frame.interpreter().values();
    return value == null ? values.nil : values.string(Utf8Text.toUrbi(value));
  }

  @Builtin(doc = "The value of a variable of the environment; nil if it is not set.")
  UrbiObject getenv(Frame frame, UrbiObject self, String name) {
    return value(frame, environment.get(Utf8Text.toJava(name)));
  }

  @Builtin(doc = "Sets a variable of the environment, and returns its value.")
  String setenv(Frame frame, CallSite site, UrbiObject self, String name, UrbiObject value) {
    String text = frame.interpreter().asString(frame, value);
    if (text.indexOf('\0') >= 0) {
      throw frame.error(site, Problem.VARIABLE_VALUE);
    }
    environment.set(name(frame, site, name), Utf8Text.toJava(text));
    return text;
  }

  @Builtin(doc = "Removes a variable of the environment, and returns its value; nil without one.")
  UrbiObject unsetenv(Frame frame, UrbiObject self, String name) {
    return value(frame, environment.unset(Utf8Text.toJava(name)));
  }
}
