package urbi;

/**
 * The components of a pixel as {@link java.awt.image.BufferedImage#getRGB} has it: from 0 to 255,
 * luminance and differences by recommendation 601.
 */
public final class ImageFilter {
  private static final int MIDDLE = 128;

  private ImageFilter() {}

  public static double getRed(int pixel) {
    return pixel >> 16 & 0xff;
  }

  public static double getGreen(int pixel) {
    return pixel >> 8 & 0xff;
  }

  public static double getBlue(int pixel) {
    return pixel & 0xff;
  }

  /** The luminance. */
  public static double getY(int pixel) {
    return 0.299 * getRed(pixel) + 0.587 * getGreen(pixel) + 0.114 * getBlue(pixel);
  }

  /** The difference of red. */
  public static double getCr(int pixel) {
    return MIDDLE + (getRed(pixel) - getY(pixel)) / 1.402;
  }

  /** The difference of blue. */
  public static double getCb(int pixel) {
    return MIDDLE + (getBlue(pixel) - getY(pixel)) / 1.772;
  }
}
