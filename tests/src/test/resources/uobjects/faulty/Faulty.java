import urbi.UObject;
import urbi.UVar;

/** Does everything wrong. */
public class Faulty extends UObject {
  static {
    UStart(Faulty.class);
  }

  private UVar val = new UVar();
  private UVar unbound = new UVar();

  public Faulty(String name) {
    super(name);
    UBindVar(val, "val");
    UBindFunctions("init", "fail", "failWithoutMessage", "recurse", "useUnbound", "useNobody", "bindNothing");
    UBindFunctions("failLater", "callBack");
    UNotifyChange(val, "failToHear");
  }

  public void init(int how) {
    if (how == 1) {
      throw new IllegalStateException("no power");
    }
  }

  public void fail(String message) {
    throw new IllegalStateException(message);
  }

  public void failWithoutMessage() {
    throw new UnsupportedOperationException();
  }

  public int recurse(int depth) {
    return recurse(depth + 1) + 1;
  }

  public double useUnbound() {
    return unbound.doubleValue();
  }

  public void useNobody() {
    new UVar("nobody.val").setValue(1);
  }

  public void bindNothing() {
    UBindFunction("missing");
  }

  public void failLater() {
    USetTimer(50, this, "failToWork");
  }

  public int failToWork() {
    throw new IllegalStateException("too late");
  }

  public void failToHear() {
    throw new IllegalStateException("deaf");
  }

  public void callBack(String name) {
    val.setValue(new UVar(name).getUValue());
  }
}
