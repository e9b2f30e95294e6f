package examples.uobjectjava;

import urbi.UObject;
import urbi.UValue;
import urbi.UVar;

/** Reads and writes variables that are not its own. */
public class OtherVariables extends UObject {
  static {
    UStart(OtherVariables.class);
  }

  public OtherVariables(String name) {
    super(name);
    UBindFunctions("get", "set");
  }

  /** The value that a variable has now: asks for it and waits. */
  public UValue get(String variable) {
    UVar other = new UVar(variable);
    other.syncValue();
    return other.getUValue();
  }

  public void set(String variable, UValue value) {
    new UVar(variable).setValue(value);
  }
}
