package org.urbi.kernel.library.object;

import java.util.regex.Pattern;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.TakenCode;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;

/** The names visible from everywhere (manual, "Global"). */
@UrbiType(
    value = "Global",
    protos = {"Tag.tags", "Math", "System", "uobjects"},
    doc = "The namespace of all objects.",
    needs = Permission.NOTHING)
final class GlobalType {
  private static final Pattern NAMES = Pattern.compile("[A-Za-z_]\\w*(\\.[A-Za-z_]\\w*)*");

  private GlobalType() {}

  @Builtin(doc = "The method of that name as a function whose first argument is the target.")
  static UrbiObject methodToFunction(Frame frame, UrbiObject self, String name) {
    return TakenCode.by(frame, new MethodFunction(self.world(), name));
  }

  @Builtin(
      lazy = true,
      min = 1,
      max = 1,
      doc = "Whether a name, or names with dots between them, stands for something.")
  static boolean isdef(Frame frame, CallSite site, UrbiObject self) {
    Node argument = site.argumentNodes()[0];
    String written = argument.isWritten() ? argument.span().text() : "";
    String name =
        NAMES.matcher(written).matches()
            ? written
            : frame.interpreter().asString(frame, argument.execute(frame));
    UrbiObject at = self;
    for (String part : name.split("\\.")) {
      Symbol symbol = self.world().symbol(part);
      if (at == self.world().values().voidObject) {
        return false;
      }
      if (at.locate(symbol) == null) {
        at.noteAbsence();
        return false;
      }
      at = frame.interpreter().get(frame, at, symbol);
    }
    return true;
  }
}
