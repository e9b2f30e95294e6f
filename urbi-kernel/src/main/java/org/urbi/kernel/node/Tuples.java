package org.urbi.kernel.node;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiTuple;

/**
 * The members of tuples, and of objects that inherit from Tuple and have a slot {@code members}.
 */
public final class Tuples {
  private Tuples() {}

  /** The members; null when the value is no tuple. */
  public static @Nullable List<UrbiObject> members(Frame frame, UrbiObject value) {
    if (value instanceof UrbiTuple tuple) {
      return tuple.elements();
    }
    return value.isA(frame.interpreter.values().tupleProto)
            && frame.interpreter.send(frame, value, "members") instanceof UrbiList list
        ? list.elements()
        : null;
  }
}
