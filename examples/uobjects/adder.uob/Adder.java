import urbi.UObject;
import urbi.UVar;

/** A variable and a function that adds to it, both for urbiscript. */
public class Adder extends UObject {
  static {
    UStart(Adder.class);
  }

  private final UVar v = new UVar();

  /** Everything is bound here: the prototype {@code Adder} has it already. */
  public Adder(String name) {
    super(name);
    UBindVar(v, "v");
    v.setValue(42);
    UBindFunction("add");
  }

  public double add(double summand) {
    return v.doubleValue() + summand;
  }
}
