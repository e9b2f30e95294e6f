package org.urbi.kernel.node;

import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.UrbiObject;

/** Evaluates the arguments of calls: none may be void. */
final class Arguments {
  private Arguments() {}

  static UrbiObject notVoid(Frame frame, Node node) {
    UrbiObject value = node.execute(frame);
    if (value == frame.interpreter.values().voidObject) {
      throw unexpectedVoid(frame, node);
    }
    return value;
  }

  private static UrbiException unexpectedVoid(Frame frame, Node node) {
    return frame.located(frame.interpreter.errors().unexpectedVoid(), node.span());
  }

  /** Evaluates the arguments into an array of at least that size, from its beginning. */
  static UrbiObject[] evaluate(Frame frame, Node[] nodes, int size) {
    UrbiObject[] values = new UrbiObject[size];
    for (int i = 0; i < nodes.length; i++) {
      values[i] = notVoid(frame, nodes[i]);
    }
    return values;
  }
}
