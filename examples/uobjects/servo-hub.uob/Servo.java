import urbi.UObject;
import urbi.UVar;

/** A servomotor whose commands go out together with those of the others, by {@link ServoHub}. */
public class Servo extends UObject {
  static {
    UStartRename(Servo.class, "servo");
  }

  private static final double PERIOD_MILLISECONDS = 1;

  private final UVar val = new UVar();
  private int id;

  public Servo(String name) {
    super(name);
    UBindFunction("init");
  }

  public int init(int motor) {
    id = motor;
    if (!Motors.initialize(id)) {
      return 1;
    }
    UBindVar(val, "val");
    UOwned(val);
    val.setValue(0);
    USetTimer(PERIOD_MILLISECONDS, this, "getVal");
    URegister(ServoHub.class);
    return 0;
  }

  public void getVal() {
    val.setValue(Motors.getPosition(id));
  }

  int id() {
    return id;
  }

  /** Where it is to go; NaN as long as nobody has said. */
  double target() {
    return val.in();
  }
}
