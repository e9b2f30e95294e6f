import urbi.UBlendType;
import urbi.UObject;
import urbi.UVar;

/** A servomotor: {@code headPan.val = 13} sends it there, {@code headPan.val} asks where it is. */
public class Servo extends UObject {
  static {
    UStartRename(Servo.class, "servo");
  }

  private final UVar val = new UVar();
  private final UVar p = new UVar();
  private final UVar i = new UVar();
  private final UVar d = new UVar();
  private int id;

  public Servo(String name) {
    super(name);
    UBindFunction("init");
  }

  /** Takes the motor of that number, {@code servo.new(1)}; there has to be one, which is free. */
  public int init(int motor) {
    id = motor;
    if (!Motors.initialize(id)) {
      return 1;
    }
    UBindVar(val, "val");
    // Sensor and actuator in one: what is written is the target, what is read the position.
    UOwned(val);
    val.blend.setValue(UBlendType.UMIX);

    UBindVars(p, "P", i, "I", d, "D");
    p.setValue(0);
    i.setValue(0);
    d.setValue(0);
    UBindFunction("setPID");

    UNotifyChange(val, "valueChanged");
    UNotifyAccess(val, "valueAccessed");
    UNotifyChange(p, "pidChanged");
    UNotifyChange(i, "pidChanged");
    UNotifyChange(d, "pidChanged");
    return 0;
  }

  /** Somebody has written {@code val}: the motor is to go there. */
  public void valueChanged(UVar v) {
    Motors.setPosition(id, v.doubleValue());
  }

  /** Somebody is about to read {@code val}: where is the motor? */
  public void valueAccessed(UVar v) {
    v.setValue(Motors.getPosition(id));
  }

  public void pidChanged() {
    Motors.setPid(id, p.intValue(), i.intValue(), d.intValue());
  }

  /** Sets all three gains; {@link #pidChanged} tells the motor. */
  public void setPID(int newP, int newI, int newD) {
    p.setValue(newP);
    i.setValue(newI);
    d.setValue(newD);
  }
}
