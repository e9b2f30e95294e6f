import java.util.Optional;
import urbi.UImage;

/** Finds an orange ball: the centre of all pixels that are much more red than blue. */
final class BallDetector {
  private static final int BYTES_PER_PIXEL = 3;
  private static final int BLUE = 2;
  private static final int LEAST_DIFFERENCE = 100;

  /** A place in a picture, in pixels from its upper left corner. */
  record Place(double x, double y) {}

  private BallDetector() {}

  static Optional<Place> detectBall(UImage rgb) {
    byte[] data = rgb.getData();
    int found = 0;
    double x = 0;
    double y = 0;
    for (int pixel = 0; pixel < rgb.getWidth() * rgb.getHeight(); pixel++) {
      int at = pixel * BYTES_PER_PIXEL;
      if ((data[at] & 0xff) - (data[at + BLUE] & 0xff) >= LEAST_DIFFERENCE) {
        found++;
        x += pixel % rgb.getWidth() + 0.5;
        y += pixel / rgb.getWidth() + 0.5;
      }
    }
    return found == 0 ? Optional.empty() : Optional.of(new Place(x / found, y / found));
  }
}
