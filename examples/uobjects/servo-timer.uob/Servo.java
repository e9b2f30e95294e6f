import urbi.UObject;
import urbi.UVar;

/** A servomotor that is asked and commanded periodically, however often urbiscript uses it. */
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
    // Read the sensors just before urbiscript runs, write the actuators just after.
    USetTimer(PERIOD_MILLISECONDS, this, "getVal");
    USetUpdate(PERIOD_MILLISECONDS);
    return 0;
  }

  public void getVal() {
    val.setValue(Motors.getPosition(id));
  }

  @Override
  public int update() {
    double target = val.in();
    if (!Double.isNaN(target)) {
      Motors.setPosition(id, target);
    }
    return 0;
  }
}
