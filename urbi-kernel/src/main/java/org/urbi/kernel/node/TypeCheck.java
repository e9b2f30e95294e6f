package org.urbi.kernel.node;

import org.urbi.kernel.object.UrbiObject;

/** Checks typed formals and variables: the value must inherit from the type. */
final class TypeCheck {
  private TypeCheck() {}

  /** Checks an argument of the function that runs in a frame. */
  static void check(Frame frame, String name, int index, UrbiObject value, UrbiObject type) {
    if (!value.isA(type)) {
      String routine = frame.calledAs() == null ? name : frame.calledAs();
      throw frame.interpreter.errors().argumentType(routine, index, value, type);
    }
  }
}
