package urbi.media;

/** Writes images of all formats. */
final class ImageEncoder {
  private ImageEncoder() {}

  /**
   * @param quality of JPEG, from 0 to 100
   */
  static byte[] encode(Pixels pixels, ImageFormat format, int quality) {
    return switch (format) {
      case RGB -> pixels.rgb().data();
      case YCBCR -> pixels.toYCbCr().data();
      case JPEG -> jpeg(pixels, quality);
      case PPM -> PpmCodec.encode(pixels.rgb());
      case YUV422 -> yuyv(pixels.toYCbCr());
      case GREY8 -> pixels.luminance();
      case GREY4 -> packed(pixels.luminance());
      case NV12, YUV420_PLANAR, YUV411_PLANAR ->
          planar(pixels.toYCbCr(), PlanarLayout.of(format, pixels.width(), pixels.height()));
      case UNKNOWN -> throw new MediaException("the format that an image should get is not known");
    };
  }

  private static byte[] jpeg(Pixels pixels, int quality) {
    if (quality < 0 || quality > 100) {
      throw new MediaException("the quality of a JPEG is from 0 to 100, not " + quality);
    }
    return Jpeg.encode(pixels.rgb(), quality);
  }

  private static byte[] packed(byte[] grey) {
    byte[] result = new byte[(grey.length + 1) / 2];
    for (int i = 0; i < grey.length; i++) {
      int step = ((grey[i] & 0xff) + 8) / 17;
      result[i / 2] |= (byte) (i % 2 == 0 ? step << 4 : step);
    }
    return result;
  }

  private static byte[] yuyv(Pixels pixels) {
    int pairs = (pixels.width() + 1) / 2;
    byte[] data = pixels.data();
    byte[] result = new byte[4 * pairs * pixels.height()];
    int to = 0;
    for (int y = 0; y < pixels.height(); y++) {
      for (int x = 0; x < pixels.width(); x += 2) {
        int first = 3 * (y * pixels.width() + x);
        int second = x + 1 < pixels.width() ? first + 3 : first;
        result[to++] = data[first];
        result[to++] = mean(data[first + 1], data[second + 1]);
        result[to++] = data[second];
        result[to++] = mean(data[first + 2], data[second + 2]);
      }
    }
    return result;
  }

  private static byte mean(byte a, byte b) {
    return (byte) ((a & 0xff) + (b & 0xff) + 1 >> 1);
  }

  private static byte[] planar(Pixels pixels, PlanarLayout layout) {
    byte[] result = new byte[Math.toIntExact(layout.size())];
    for (int y = 0; y < layout.height(); y++) {
      for (int x = 0; x < layout.width(); x++) {
        result[y * layout.width() + x] = pixels.data()[3 * (y * layout.width() + x)];
      }
    }
    for (int y = 0; y < layout.height(); y += layout.rows()) {
      for (int x = 0; x < layout.width(); x += layout.columns()) {
        result[layout.blue(x, y)] = mean(pixels, layout, x, y, 1);
        result[layout.red(x, y)] = mean(pixels, layout, x, y, 2);
      }
    }
    return result;
  }

  /** The mean of a component over the neighbours that share it. */
  private static byte mean(Pixels pixels, PlanarLayout layout, int left, int top, int component) {
    int sum = 0;
    int count = 0;
    for (int y = top; y < Math.min(top + layout.rows(), layout.height()); y++) {
      for (int x = left; x < Math.min(left + layout.columns(), layout.width()); x++) {
        sum += pixels.data()[3 * (y * layout.width() + x) + component] & 0xff;
        count++;
      }
    }
    return (byte) ((sum + count / 2) / count);
  }
}
