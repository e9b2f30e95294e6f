import java.util.Optional;
import urbi.UImage;
import urbi.UObject;
import urbi.UVar;

/** Says whether there is a ball in the pictures of a camera, and where. */
public class BallTracker extends UObject {
  static {
    UStart(BallTracker.class);
  }

  private final UVar visible = new UVar();
  private final UVar x = new UVar();
  private final UVar y = new UVar();

  public BallTracker(String name) {
    super(name);
    UBindFunction("init");
  }

  /**
   * @param camera the name of a variable that holds images, {@code "camera.val"}
   */
  public void init(String camera) {
    UBindVars(visible, "visible", x, "x", y, "y");
    visible.setValue(0);
    x.setValue(0);
    y.setValue(0);
    UNotifyChange(camera, "newImage");
  }

  /** Looks for the ball; {@code x} and {@code y} go from 0 to 1, from left to right and down. */
  public void newImage(UVar v) {
    UImage image = v.uimageValue();
    Optional<BallDetector.Place> ball = BallDetector.detectBall(image);
    // The place first: whoever waits for visible finds it.
    ball.ifPresent(place -> {
      x.setValue(place.x() / image.getWidth());
      y.setValue(place.y() / image.getHeight());
    });
    visible.setValue(ball.isPresent());
  }
}
