package urbi.media;

/**
 * An image with three bytes for each pixel.
 *
 * @param ycbcr whether they are luminance and differences; otherwise red, green, blue
 */
record Pixels(int width, int height, boolean ycbcr, byte[] data) {
  Pixels rgb() {
    return ycbcr ? new Pixels(width, height, false, Colours.toRgb(data)) : this;
  }

  Pixels toYCbCr() {
    return ycbcr ? this : new Pixels(width, height, true, Colours.toYCbCr(data));
  }

  /** One byte of luminance for each pixel. */
  byte[] luminance() {
    if (!ycbcr) {
      return Colours.luminance(data);
    }
    byte[] result = new byte[width * height];
    for (int i = 0; i < result.length; i++) {
      result[i] = data[3 * i];
    }
    return result;
  }

  void check(String format) {
    requireSize(format, width, height, data, 3L * width * height);
  }

  static void requireSize(String format, int width, int height, byte[] data, long size) {
    if (width <= 0 || height <= 0) {
      throw new MediaException("an image has no size: " + format + " " + width + " " + height);
    }
    if (size > Integer.MAX_VALUE - 64) {
      throw new MediaException("an image is too large: " + width + " x " + height);
    }
    if (data.length < size) {
      throw new MediaException(
          "an image of "
              + width
              + " x "
              + height
              + " pixels in "
              + format
              + " has "
              + data.length
              + " bytes instead of "
              + size);
    }
  }

  /** The image in another size, each pixel a blend of those that it comes from. */
  Pixels scaled(int newWidth, int newHeight) {
    if (newWidth == width && newHeight == height) {
      return this;
    }
    if (newWidth < 0 || newHeight < 0 || 3L * newWidth * newHeight > Integer.MAX_VALUE - 64) {
      throw new MediaException("no size of an image: " + newWidth + " x " + newHeight);
    }
    byte[] result = new byte[3 * newWidth * newHeight];
    int to = 0;
    for (int y = 0; y < newHeight; y++) {
      double v = position(y, height, newHeight);
      int top = (int) v;
      int bottom = Math.min(top + 1, height - 1);
      for (int x = 0; x < newWidth; x++) {
        double u = position(x, width, newWidth);
        int left = (int) u;
        int right = Math.min(left + 1, width - 1);
        for (int i = 0; i < 3; i++) {
          double above = blend(at(left, top, i), at(right, top, i), u - left);
          double below = blend(at(left, bottom, i), at(right, bottom, i), u - left);
          result[to++] = (byte) Math.round(blend(above, below, v - top));
        }
      }
    }
    return new Pixels(newWidth, newHeight, ycbcr, result);
  }

  /** Where the middle of a new pixel is among the middles of the old ones. */
  private static double position(int index, int size, int newSize) {
    return Math.clamp((index + 0.5) * size / newSize - 0.5, 0, size - 1);
  }

  private static double blend(double a, double b, double share) {
    return a + (b - a) * share;
  }

  private int at(int x, int y, int component) {
    return data[3 * (y * width + x) + component] & 0xff;
  }
}
