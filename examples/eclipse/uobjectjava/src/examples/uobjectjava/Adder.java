package examples.uobjectjava;

import urbi.UObject;
import urbi.UVar;

/** A variable and a function. {@code new} is given the first value of the variable. */
public class Adder extends UObject {
  static {
    UStart(Adder.class);
  }

  private final UVar v = new UVar();

  public Adder(String name) {
    super(name);
    UBindFunction("init");
  }

  public int init(double value) {
    UBindVar(v, "v");
    v.setValue(value);
    UBindFunction("add");
    return 0;
  }

  public double add(double summand) {
    return v.doubleValue() + summand;
  }
}
