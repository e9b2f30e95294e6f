package org.urbi.kernel.library.code;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.value.Counting;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** How a function was called (manual, "CallMessage"). */
@UrbiType(
    value = "CallMessage",
    doc = "A call: its target, its name, its arguments.",
    needs = Permission.NOTHING)
final class CallMessageType {
  private CallMessageType() {}

  private static UrbiObject slot(Frame frame, UrbiObject self, String name) {
    return frame.interpreter().get(frame, self, self.world().symbol(name));
  }

  private static List<UrbiObject> arguments(Frame frame, UrbiObject self) {
    return frame.interpreter().callMessages().arguments(frame, self);
  }

  @Builtin(doc = "The number of arguments.")
  static double argsCount(Frame frame, UrbiObject self) {
    return arguments(frame, self).size();
  }

  @Builtin(
      value = {"evalArgAt", "argAt"},
      doc = "Evaluates the argument at that index; each time anew.")
  static UrbiObject evalArgAt(Frame frame, CallSite site, UrbiObject self, UrbiFloat index) {
    return frame.interpreter().callMessages().evaluate(frame, argument(frame, site, self, index));
  }

  private static UrbiObject argument(Frame frame, CallSite site, UrbiObject self, UrbiFloat index) {
    List<UrbiObject> arguments = arguments(frame, self);
    int place = Counting.index(frame, site, index);
    if (place < 0 || place >= arguments.size()) {
      throw Counting.invalidIndex(frame, site, place);
    }
    return arguments.get(place);
  }

  @Builtin(doc = "The text of the argument at that index.")
  static String argString(Frame frame, CallSite site, UrbiObject self, UrbiFloat index) {
    return frame.interpreter().asString(frame, argument(frame, site, self, index));
  }

  @Builtin(doc = "Evaluates all arguments, and returns the list of their values.")
  static List<UrbiObject> evalArgs(Frame frame, CallSite site, UrbiObject self) {
    List<UrbiObject> values = new ArrayList<>();
    for (UrbiObject argument : arguments(frame, self)) {
      UrbiObject value = frame.interpreter().callMessages().evaluate(frame, argument);
      if (value == frame.interpreter().values().voidObject) {
        throw frame.error(site, Problem.VOID_ARGUMENT);
      }
      values.add(value);
    }
    return values;
  }

  @Builtin(doc = "Makes the call, and returns its value.")
  static UrbiObject eval(Frame frame, UrbiObject self) {
    return send(frame, self, slot(frame, self, "target"));
  }

  /** Makes a call on a target; functions that want their arguments unevaluated get them so. */
  static UrbiObject send(Frame frame, UrbiObject self, UrbiObject target) {
    String name = frame.interpreter().asString(frame, slot(frame, self, "message"));
    CallSite site = new MessageSite(name, frame, arguments(frame, self));
    Symbol message = self.world().symbol(name);
    if (target.locate(message) == null) {
      return frame.interpreter().fallback(frame, site, target, message);
    }
    UrbiObject called = slot(frame, target, name);
    if (called instanceof Code code) {
      UrbiObject[] arguments =
          code.isLazy()
              ? new UrbiObject[arguments(frame, self).size()]
              : evalArgs(frame, site, self).toArray(UrbiObject[]::new);
      return code.call(frame, site, target, arguments);
    }
    return called;
  }

  /** A call made by a call message. */
  private static final class MessageSite implements CallSite {
    private final String name;
    private final Node[] arguments;

    MessageSite(String name, Frame frame, List<UrbiObject> lazies) {
      this.name = name;
      this.arguments = new Node[lazies.size()];
      for (int i = 0; i < arguments.length; i++) {
        UrbiObject lazy = lazies.get(i);
        arguments[i] =
            new Node() {
              @Override
              public UrbiObject execute(Frame evaluator) {
                return frame.interpreter().send(evaluator, lazy, "eval");
              }
            };
      }
    }

    @Override
    public String calledName() {
      return name;
    }

    @Override
    public @Nullable Span calledSpan() {
      return null;
    }

    @Override
    public Node[] argumentNodes() {
      return arguments;
    }
  }
}
