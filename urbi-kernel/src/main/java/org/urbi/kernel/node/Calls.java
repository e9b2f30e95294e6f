package org.urbi.kernel.node;

import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;

/** Calls the value that a lookup has found. */
final class Calls {
  private Calls() {}

  /** Calls a function or a primitive with arguments that are still code. */
  static UrbiObject call(Frame frame, CallSite site, Code code, UrbiObject self, Node[] arguments) {
    if (code instanceof Function function) {
      Formals formals = function.formals();
      if (function.usesCall()) {
        handOut(frame, arguments);
      }
      if (formals == null) {
        return function.runLazily(frame, site, self);
      }
      if (formals.isSimple(arguments.length)) {
        return function.run(
            frame,
            site,
            self,
            ArgumentEvaluation.evaluate(frame, arguments, function.layout().locals()));
      }
      formals.check(frame, site, arguments.length);
    } else if (code.isLazy()) {
      handOut(frame, arguments);
      return code.call(frame, site, self, placeholders(arguments));
    }
    return code.call(
        frame, site, self, ArgumentEvaluation.evaluate(frame, arguments, arguments.length));
  }

  /** Whoever is called may evaluate these arguments at any time; none are nothing. */
  private static void handOut(Frame frame, Node[] arguments) {
    if (arguments.length > 0) {
      frame.exposeLocals();
    }
  }

  /**
   * Placeholders for the arguments of a lazy primitive, which reads their code: only their number
   * matters.
   */
  private static UrbiObject[] placeholders(Node[] arguments) {
    return new UrbiObject[arguments.length];
  }

  /** The value of a slot that holds no function. */
  static UrbiObject plain(
      Frame frame, CallSite site, UrbiObject value, UrbiObject self, Node[] arguments) {
    if (arguments.length == 0) {
      return value;
    }
    return frame.interpreter.call(
        frame, site, value, self, ArgumentEvaluation.evaluate(frame, arguments, arguments.length));
  }

  /** Handles a missing slot: the {@code fallback} of the object is called, if it has one. */
  static UrbiObject fallback(
      Frame frame, CallSite site, UrbiObject self, Symbol name, Node[] arguments) {
    UrbiObject fallback = self.lookup(frame.interpreter.symbols().fallback);
    if (!(fallback instanceof Code code)) {
      throw frame.interpreter.errors().lookup(self, name.name());
    }
    return call(frame, site, code, self, arguments);
  }
}
