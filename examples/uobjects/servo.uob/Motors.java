import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** The servomotors of a robot that we do not have: they go at once where they are sent. */
final class Motors {
  private static final int HIGHEST_ID = 15;
  private static final double STOP = 90;
  private static final Map<Integer, Double> POSITIONS = new ConcurrentHashMap<>();

  private Motors() {}

  /** Switches a motor on; false if there is no such motor. */
  static boolean initialize(int id) {
    return 0 <= id && id <= HIGHEST_ID && POSITIONS.putIfAbsent(id, 0.0) == null;
  }

  /** Where it is, in degrees. */
  static double getPosition(int id) {
    return POSITIONS.get(id);
  }

  /** Sends it to a position, in degrees; it has mechanical stops at ±90. */
  static void setPosition(int id, double position) {
    POSITIONS.put(id, Math.clamp(position, -STOP, STOP));
  }

  /** Sets the parameters of its controller. */
  static void setPid(int id, int p, int i, int d) {
    if (p < 0 || i < 0 || d < 0) {
      throw new IllegalArgumentException("motor " + id + ": a gain cannot be negative");
    }
  }
}
