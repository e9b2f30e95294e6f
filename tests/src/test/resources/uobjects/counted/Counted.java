import urbi.UObject;
import urbi.UVar;

/** The adder whose variable is bound by its urbiscript constructor. */
public class Counted extends UObject {
  static {
    UStart(Counted.class);
  }

  private UVar v = new UVar();

  public Counted(String name) {
    super(name);
    UBindFunction("init");
  }

  public int init(double start) {
    UBindVar(v, "v");
    v.setValue(start);
    String[] types = {"double"};
    UBindFunction(this, "add", types);
    return 0;
  }

  public double add(double rhs) {
    return v.doubleValue() + rhs;
  }
}
