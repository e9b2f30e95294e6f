package examples.uobjectjava;

import urbi.UObject;
import urbi.UVar;

/** Is told when variables change: one of its own, and one that urbiscript names. */
public class Notifications extends UObject {
  static {
    UStart(Notifications.class);
  }

  private final UVar own = new UVar();

  public Notifications(String name) {
    super(name);
    UBindFunction("init");
  }

  /**
   * @param other the name of another variable, {@code "Global.a"}, or an empty string
   */
  public void init(String other) {
    UBindVar(own, "own");
    own.setValue(1);
    UNotifyChange(own, "ownChanged");
    if (!other.isEmpty()) {
      UNotifyChange(other, "otherChanged");
    }
  }

  /** Is given the new value. */
  public void ownChanged(double value) {
    tell("own is now " + Math.round(value));
  }

  /** Is given the variable. */
  public void otherChanged(UVar variable) {
    tell(variable.getName() + " is now " + variable.getUValue());
  }

  private void tell(String message) {
    send("wall(\"" + message.replace("\"", "'") + "\");");
  }
}
