import java.util.SortedMap;
import java.util.TreeMap;
import urbi.UObjectHub;

/** Collects the positions of all servos, and sends them at once. */
public class ServoHub extends UObjectHub {
  private final SortedMap<Integer, Double> collected = new TreeMap<>();
  private String sent = "";

  public ServoHub(String name) {
    super(name);
    USetUpdate(100);
  }

  void addValue(int id, double value) {
    collected.put(id, value);
  }

  String positions() {
    return sent;
  }

  @Override
  public int update() {
    sent = collected.toString();
    collected.clear();
    return 0;
  }
}
