import urbi.UObject;
import urbi.UVar;

/** One of the motors of which the hub drives all. */
public class Servo extends UObject {
  static {
    UStart(Servo.class);
    UStartHub(ServoHub.class);
  }

  private UVar val = new UVar();
  private UVar before = new UVar();
  int id;

  public Servo(String name) {
    super(name);
    UBindFunctions("init", "stop", "positions", "members");
  }

  public void init(int number) {
    id = number;
    UBindVar(val, "val");
    UBindVar(before, "before");
    before.setValue(0);
    val.setValue(0);
    UOwned(val);
    URegister("ServoHub");
    USetUpdate(50);
    USetTimer(50, this, "getVal");
  }

  @Override
  public int update() {
    ((ServoHub) getUObjectHub("ServoHub")).addValue(id, val.doubleValue());
    return 0;
  }

  public int getVal() {
    val.setValue(val.doubleValue() / 2);
    before.setValue(before.doubleValue() + 1);
    return 0;
  }

  public void stop() {
    USetUpdate(-1);
  }

  public String positions() {
    return ((ServoHub) getUObjectHub("ServoHub")).positions();
  }

  public int members() {
    return getUObjectHub("ServoHub").members.size();
  }
}
