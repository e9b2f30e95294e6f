import urbi.UObject;
import urbi.UVar;

/** A variable with everything that can be hooked to it; it notes what happens. */
public class Sensor extends UObject {
  static {
    UStart(Sensor.class);
  }

  private UVar val = new UVar();
  private UVar other = new UVar();
  private UVar log = new UVar();
  private int accesses;

  public Sensor(String name) {
    super(name);
    UBindVars(val, "val", other, "other", log, "log");
    log.setValue("");
    UBindFunctions("own", "watch", "watchName", "watchValue", "serve", "unwatch", "write", "read");
    UBindFunctions("readName", "writeName", "target", "limits", "setBlend", "times");
  }

  private void note(String text) {
    String before = log.stringValue();
    log.setValue(before.isEmpty() ? text : before + " " + text);
  }

  public void own() {
    UOwned(val);
  }

  public void watch() {
    UNotifyChange(val, "changed");
  }

  public void watchName(String name) {
    UNotifyChange(name, "changed");
  }

  public void watchValue(UVar source) {
    UNotifyChange(source, "came");
  }

  public void serve() {
    UNotifyAccess(val, "accessed");
  }

  public void unwatch() {
    val.unnotify();
  }

  public int changed(UVar v) {
    note(v.getName().replaceAll("_0x[0-9a-f]*", "") + "=" + v.getUValue());
    return 0;
  }

  public void came(double value) {
    note("came " + (int) value);
  }

  public void accessed() {
    val.setValue(++accesses);
  }

  public void write(double value) {
    val.setValue(value);
  }

  public double read() {
    return val.doubleValue();
  }

  public double readName(String name) {
    return new UVar(name).doubleValue();
  }

  public void writeName(String name, double value) {
    new UVar(name).setValue(value);
  }

  public double target() {
    return val.in();
  }

  public String limits() {
    return val.rangemin.getUValue() + " " + val.rangemax.getUValue() + " " + val.blend.getUValue();
  }

  public void setBlend(String mode) {
    val.blend.setValue(mode);
    val.rangemax.setValue(10);
  }

  public boolean times() {
    return val.timestamp() >= 0;
  }
}
