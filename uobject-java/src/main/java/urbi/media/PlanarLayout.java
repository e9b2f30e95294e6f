package urbi.media;

/**
 * Where the luminance and the differences of a pixel are, in formats in which neighbours share
 * their differences.
 *
 * @param columns how many neighbours in a row share them
 * @param rows how many rows share them
 */
record PlanarLayout(int width, int height, int columns, int rows, boolean interleaved) {
  /** The layout of a format that has one. */
  static PlanarLayout of(ImageFormat format, int width, int height) {
    return switch (format) {
      case NV12 -> new PlanarLayout(width, height, 2, 2, true);
      case YUV420_PLANAR -> new PlanarLayout(width, height, 2, 2, false);
      case YUV411_PLANAR -> new PlanarLayout(width, height, 4, 1, false);
      default -> throw new IllegalArgumentException(format + " is not planar");
    };
  }

  private int planeWidth() {
    return (width + columns - 1) / columns;
  }

  private int planeSize() {
    return planeWidth() * ((height + rows - 1) / rows);
  }

  /** How many bytes an image has. */
  long size() {
    long across = (width + columns - 1) / columns;
    long down = (height + rows - 1) / rows;
    return (long) width * height + 2 * across * down;
  }

  private int shared(int x, int y) {
    return y / rows * planeWidth() + x / columns;
  }

  int blue(int x, int y) {
    return width * height + (interleaved ? 2 * shared(x, y) : shared(x, y));
  }

  int red(int x, int y) {
    return interleaved ? blue(x, y) + 1 : blue(x, y) + planeSize();
  }
}
