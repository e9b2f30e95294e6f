import java.util.ArrayList;
import java.util.List;
import urbi.UObject;
import urbi.UObjectHub;

/** Sends the targets of all servos by one command. There is one hub, from the start. */
public class ServoHub extends UObjectHub {
  static {
    UObject.UStartHub(ServoHub.class);
  }

  private static final double PERIOD_MILLISECONDS = 1;

  public ServoHub(String name) {
    super(name);
    USetUpdate(PERIOD_MILLISECONDS);
  }

  @Override
  public int update() {
    List<Integer> ids = new ArrayList<>();
    List<Double> targets = new ArrayList<>();
    for (UObject member : members) {
      Servo servo = (Servo) member;
      if (!Double.isNaN(servo.target())) {
        ids.add(servo.id());
        targets.add(servo.target());
      }
    }
    Motors.setPositions(ids, targets);
    return 0;
  }
}
