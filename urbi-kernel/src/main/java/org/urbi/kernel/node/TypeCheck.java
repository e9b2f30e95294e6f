package org.urbi.kernel.node;

import org.urbi.kernel.object.UrbiObject;

/** The types of typed formals and variables: a value fits if it inherits from the type. */
final class TypeCheck {
  private TypeCheck() {}

  /** Checks an argument of the function whose activation this is. */
  static void check(Frame frame, String name, int index, UrbiObject value, UrbiObject type) {
    if (!value.isA(type)) {
      String routine = frame.calledAs() == null ? name : frame.calledAs();
      throw frame.interpreter.errors().argumentType(routine, index, value, type);
    }
  }
}
