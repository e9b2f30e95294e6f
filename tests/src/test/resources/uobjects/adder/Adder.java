import urbi.UObject;
import urbi.UVar;

public class Adder extends UObject {
  static {
    UStart(Adder.class);
  }

  private UVar v = new UVar();

  public Adder(String name) {
    super(name);
    UBindVar(v, "v");
    v.setValue(42);
    UBindFunction("add");
  }

  public double add(double rhs) {
    return v.doubleValue() + rhs;
  }
}
