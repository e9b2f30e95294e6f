package org.urbi.kernel.lobby;

import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;

/** Shows the values of statements to the client of a lobby. */
public final class TopLevel {
  private TopLevel() {}

  /** Whether a value is shown: void and nil are not. */
  public static boolean isShown(Interpreter interpreter, UrbiObject value) {
    return value != interpreter.values().voidObject
        && value != interpreter.values().acceptedVoid
        && value != interpreter.values().nil;
  }

  /** Shows a value, by the slot {@code topLevel} of the lobby. */
  public static void show(Frame frame, UrbiLobby lobby, UrbiObject value) {
    Interpreter interpreter = frame.interpreter();
    interpreter.send(
        frame, interpreter.get(frame, lobby, interpreter.world().symbol("topLevel")), "<<", value);
  }
}
