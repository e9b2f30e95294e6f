import urbi.UObject;
import urbi.UVar;

/** As the other Adder, but only those that {@code new} has made have a variable. */
public class Adder extends UObject {
  static {
    UStart(Adder.class);
  }

  private final UVar v = new UVar();

  /** Of the prototype {@code Adder} nothing can be used but {@code Adder.new}. */
  public Adder(String name) {
    super(name);
    UBindFunction("init");
  }

  /** The constructor of urbiscript, {@code Adder.new(51)}; a result other than 0 says it failed. */
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
