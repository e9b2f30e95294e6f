package org.urbi.kernel.event;

import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.object.UrbiObject;

/** Evaluates an expression to an event. */
final class EventLookup {
  private EventLookup() {}

  /**
   * The event that an expression evaluates to; a value of another type is converted by its {@code
   * asEvent}.
   */
  static UrbiEvent event(Frame frame, Node expression) {
    UrbiObject value = expression.execute(frame);
    if (value instanceof UrbiEvent event) {
      return event;
    }
    var interpreter = frame.interpreter();
    UrbiObject converter = value.lookup(interpreter.world().symbol("asEvent"));
    if (converter != null && interpreter.send(frame, value, "asEvent") instanceof UrbiEvent event) {
      return event;
    }
    throw frame.located(
        interpreter.errors().argumentType("?", 0, value, interpreter.prototypes().event),
        expression.span());
  }
}
