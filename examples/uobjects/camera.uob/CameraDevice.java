import java.util.Arrays;

/**
 * A camera that we do not have. It sees an orange ball before a grey wall; the ball goes two pixels
 * to the right from one picture to the next, until it has left the picture and comes in again.
 */
final class CameraDevice {
  static final int BYTES_PER_PIXEL = 3;

  private static final int WIDTH = 32;
  private static final int HEIGHT = 24;
  private static final int BALL_TOP = 10;
  private static final int BALL_SIZE = 4;
  private static final int STEP = 2;
  private static final byte GREY = (byte) 128;
  private static final byte[] ORANGE = {(byte) 255, (byte) 128, 0};

  private final byte[] buffer = new byte[WIDTH * HEIGHT * BYTES_PER_PIXEL];
  private int left;

  private CameraDevice() {}

  /**
   * Switches the camera on.
   *
   * @throws IllegalArgumentException if there is none of that number
   */
  static CameraDevice initialize(int id) {
    if (id != 0) {
      throw new IllegalArgumentException("there is no camera " + id);
    }
    return new CameraDevice();
  }

  int width() {
    return WIDTH;
  }

  int height() {
    return HEIGHT;
  }

  /** The next picture: red, green and blue of each pixel; the buffer is always the same. */
  byte[] getImage() {
    Arrays.fill(buffer, GREY);
    for (int y = BALL_TOP; y < BALL_TOP + BALL_SIZE; y++) {
      for (int x = left; x < Math.min(left + BALL_SIZE, WIDTH); x++) {
        System.arraycopy(
            ORANGE, 0, buffer, (y * WIDTH + x) * BYTES_PER_PIXEL, BYTES_PER_PIXEL);
      }
    }
    left = (left + STEP) % (WIDTH + STEP);
    return buffer;
  }
}
