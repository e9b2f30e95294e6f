import urbi.UObject;
import urbi.UVar;

/** A component: what urbiscript sees of it is bound in the constructor. */
public class {{CLASS}} extends UObject {
  static {
    UStart({{CLASS}}.class);
  }

  private final UVar val = new UVar();

  public {{CLASS}}(String name) {
    super(name);
    UBindVar(val, "val");
    val.setValue(0);
    UBindFunction("add");
  }

  /** Adds to {@code val}, and returns what it has become. */
  public double add(double summand) {
    val.setValue(val.doubleValue() + summand);
    return val.doubleValue();
  }
}
