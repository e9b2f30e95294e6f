package org.urbi.kernel.node;

import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** Evaluates the arguments of calls: none may be void. */
final class ArgumentEvaluation {
  private ArgumentEvaluation() {}

  /**
   * The value of a node that a construct uses.
   *
   * @param at the construct, which is where an error is reported
   */
  static UrbiObject notVoid(Frame frame, Node node, Span at) {
    UrbiObject value = node.execute(frame);
    if (value == frame.interpreter.values().voidObject) {
      throw unexpectedVoid(frame, at);
    }
    return value;
  }

  private static UrbiException unexpectedVoid(Frame frame, Span at) {
    return frame.located(frame.interpreter.errors().unexpectedVoid(), at);
  }

  /**
   * Evaluates the arguments into an array of at least that size, from its beginning. An error is
   * reported at the location of the call.
   */
  static UrbiObject[] evaluate(Frame frame, Node[] nodes, int size) {
    UrbiObject[] values = new UrbiObject[size];
    for (int i = 0; i < nodes.length; i++) {
      values[i] = frame.interpreter.notVoid(nodes[i].execute(frame));
    }
    return values;
  }
}
