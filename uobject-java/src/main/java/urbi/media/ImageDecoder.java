package urbi.media;

/** Reads images of all formats. */
final class ImageDecoder {
  private static final byte MIDDLE = (byte) 128;

  private ImageDecoder() {}

  static Pixels decode(Picture image) {
    int width = image.width();
    int height = image.height();
    byte[] data = image.data();
    ImageFormat format = image.format();
    String name = format.keyword();
    return switch (format) {
      case RGB, YCBCR -> {
        Pixels pixels = new Pixels(width, height, format == ImageFormat.YCBCR, data);
        pixels.check(name);
        yield pixels;
      }
      case JPEG -> Jpeg.decode(data);
      case PPM -> PpmCodec.decode(data);
      case YUV422 -> {
        long row = 4L * ((width + 1) / 2);
        Pixels.requireSize(name, width, height, data, row * height);
        yield yuyv(width, height, data);
      }
      case GREY8 -> {
        Pixels.requireSize(name, width, height, data, (long) width * height);
        yield grey(width, height, data);
      }
      case GREY4 -> {
        Pixels.requireSize(name, width, height, data, ((long) width * height + 1) / 2);
        yield grey(width, height, unpacked(width * height, data));
      }
      case NV12, YUV420_PLANAR, YUV411_PLANAR -> {
        PlanarLayout layout = PlanarLayout.of(format, width, height);
        Pixels.requireSize(name, width, height, data, layout.size());
        yield planar(layout, data);
      }
      case UNKNOWN -> throw new MediaException("the format of an image is not known");
    };
  }

  private static Pixels grey(int width, int height, byte[] data) {
    byte[] result = new byte[3 * width * height];
    for (int i = 0; i < width * height; i++) {
      result[3 * i] = data[i];
      result[3 * i + 1] = MIDDLE;
      result[3 * i + 2] = MIDDLE;
    }
    return new Pixels(width, height, true, result);
  }

  /** 15 becomes 255: 17 for each of the sixteen steps. */
  private static byte[] unpacked(int size, byte[] data) {
    byte[] result = new byte[size];
    for (int i = 0; i < size; i++) {
      int pair = data[i / 2] & 0xff;
      result[i] = (byte) (17 * (i % 2 == 0 ? pair >> 4 : pair & 15));
    }
    return result;
  }

  private static Pixels yuyv(int width, int height, byte[] data) {
    byte[] result = new byte[3 * width * height];
    int row = 4 * ((width + 1) / 2);
    int to = 0;
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        int pair = y * row + x / 2 * 4;
        result[to++] = data[pair + x % 2 * 2];
        result[to++] = data[pair + 1];
        result[to++] = data[pair + 3];
      }
    }
    return new Pixels(width, height, true, result);
  }

  private static Pixels planar(PlanarLayout layout, byte[] data) {
    byte[] result = new byte[3 * layout.width() * layout.height()];
    int to = 0;
    for (int y = 0; y < layout.height(); y++) {
      for (int x = 0; x < layout.width(); x++) {
        result[to++] = data[y * layout.width() + x];
        result[to++] = data[layout.blue(x, y)];
        result[to++] = data[layout.red(x, y)];
      }
    }
    return new Pixels(layout.width(), layout.height(), true, result);
  }
}
