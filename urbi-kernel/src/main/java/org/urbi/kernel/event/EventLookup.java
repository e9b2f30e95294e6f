package org.urbi.kernel.event;

import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.object.UrbiObject;

/** Gets the event that an expression stands for. */
final class EventLookup {
  private EventLookup() {}

  /**
   * The event which an expression evaluates to; anything else may be seen as one by {@code
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
