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

  public long recurse(int depth) {
    return down(depth, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
  }

  /** With many arguments, because to leave a stack that is full of small frames takes seconds. */
  private static long down(
      long depth, long b, long c, long d, long e, long f, long g, long h, long i, long j, long k, long l, long m,
      long n, long o, long p) {
    return down(depth + 1, c, d, e, f, g, h, i, j, k, l, m, n, o, p, b) + d;
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
