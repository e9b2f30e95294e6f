package org.urbi.kernel.library.code;

import java.util.Arrays;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.object.ObjectType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Function;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.print.Printer;

/** Functions written in urbiscript (manual, "Code"). */
@UrbiType(
    value = "Code",
    protos = {"Comparable", "Executable"},
    doc = "A function written in urbiscript.",
    needs = Permission.NOTHING)
final class CodeType {
  private CodeType() {}

  @Builtin(doc = "Calls the function: the list holds the target, then the arguments.")
  static UrbiObject apply(Frame frame, CallSite site, Code self, UrbiObject list) {
    if (!(list instanceof UrbiList arguments)) {
      // The list begins with the target: that is what is missing.
      throw Arguments.type(frame, site, 0, list, "List");
    }
    UrbiObject[] all = arguments.elements().toArray(UrbiObject[]::new);
    if (all.length == 0) {
      throw frame.interpreter().errors().primitive("apply", Problem.WITHOUT_THIS);
    }
    return frame
        .interpreter()
        .call(frame, site, self, all[0], Arrays.copyOfRange(all, 1, all.length));
  }

  @Builtin(doc = "The text of the function.")
  static String asString(Frame frame, UrbiObject self) {
    if (self instanceof Function function) {
      return Printer.print(function.source());
    }
    if (self instanceof ScriptCode script) {
      return Printer.print(script.tree());
    }
    return self instanceof Code ? "Code_" + ObjectType.uid(self) : "Code";
  }

  @Builtin(doc = "The text of the code of the function, without its arguments.")
  static String bodyString(Frame frame, UrbiObject self) {
    return self instanceof Function function ? Printer.printBody(function.source().body()) : "";
  }

  @Builtin(
      value = {"=="},
      doc = "Whether both have the same text, and have captured the same variables.")
  static boolean equal(UrbiObject self, UrbiObject other) {
    return self == other
        || self instanceof Function mine
            && other instanceof Function its
            && mine.capturesAs(its)
            && Printer.print(mine.source()).equals(Printer.print(its.source()));
  }
}
