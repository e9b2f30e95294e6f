import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import urbi.UBinary;
import urbi.UCast;
import urbi.UDictionary;
import urbi.UEvent;
import urbi.UImage;
import urbi.UList;
import urbi.UObject;
import urbi.UValue;
import urbi.UVar;

/** Takes and gives values of all kinds. */
public class Exchange extends UObject {
  /** A structure that Java declares as a record. */
  public record Point(double x, double y) {}

  static {
    UStart(Exchange.class);
  }

  private UEvent ev = new UEvent();
  private UVar val = new UVar();

  public Exchange(String name) {
    super(name);
    UBindVar(val, "val");
    UBindEvent(ev, "ev");
    UBindFunctions(
        "byte_", "short_", "int_", "long_", "float_", "char_", "boolean_", "string", "uvalue", "kind",
        "ulist", "udictionary", "ubinary", "uimage", "list", "map", "object", "uvar", "opposite",
        "points", "numbers", "nothing", "emit", "ask", "say", "sixteen");
  }

  public byte byte_(byte value) { return value; }

  public short short_(short value) { return value; }

  public int int_(int value) { return value; }

  public long long_(Long value) { return value; }

  public float float_(float value) { return value; }

  public char char_(char value) { return value; }

  public boolean boolean_(Boolean value) { return !value; }

  public String string(String value) { return value + "!"; }

  public UValue uvalue(UValue value) { return value; }

  public String kind(UValue value) { return value.getType().toString(); }

  public UList ulist(UList value) {
    UList reversed = new UList();
    value.forEach(each -> reversed.add(0, each));
    return reversed;
  }

  public UDictionary udictionary(UDictionary value) {
    value.put("size", new UValue(value.size()));
    return value;
  }

  public UBinary ubinary(UBinary value) { return value; }

  public long uimage(UImage value) { return value.getWidth() * 1000 + value.getHeight(); }

  public double list(List<Double> values) {
    return values.stream().mapToDouble(Double::doubleValue).sum();
  }

  public List<String> map(Map<String, Integer> values) {
    List<String> lines = new ArrayList<>();
    values.forEach((name, number) -> lines.add(name + number));
    return lines;
  }

  public UObject object(UObject value) { return value; }

  public UVar uvar(UVar value) {
    value.setValue(value.doubleValue() + 1);
    return value;
  }

  public Point opposite(Point p) { return new Point(-p.x(), -p.y()); }

  public List<Point> points(double[] xs) {
    List<Point> points = new ArrayList<>();
    for (double x : xs) {
      points.add(new Point(x, 0));
    }
    return points;
  }

  public int[] numbers() { return new int[] {1, 2, 3}; }

  public void nothing() {}

  public void emit(UValue value) { ev.emit(value, "more"); }

  public void ask(double value) { call("Global", "told", value); }

  public void say(String code) { send(code); }

  public double sixteen(
      double a, double b, double c, double d, double e, double f, double g, double h,
      double i, double j, double k, double l, double m, double n, double o, double p) {
    return a + p;
  }
}
