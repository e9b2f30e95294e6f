package urbi.media;

/** Colours as JPEG has them: BT.601 in full range, in fixed point with 16 bits of fraction. */
public final class Colours {
  private static final int HALF = 1 << 15;
  private static final int MIDDLE = (128 << 16) + HALF - 1;

  private Colours() {}

  /** Red, green, blue to luminance, blue and red difference. */
  public static byte[] toYCbCr(byte[] rgb) {
    byte[] result = new byte[rgb.length / 3 * 3];
    for (int i = 0; i + 2 < rgb.length; i += 3) {
      int r = rgb[i] & 0xff;
      int g = rgb[i + 1] & 0xff;
      int b = rgb[i + 2] & 0xff;
      result[i] = luminance(r, g, b);
      result[i + 1] = (byte) (-11058 * r - 21710 * g + 32768 * b + MIDDLE >> 16);
      result[i + 2] = (byte) (32768 * r - 27439 * g - 5329 * b + MIDDLE >> 16);
    }
    return result;
  }

  /** Luminance, blue and red difference to red, green, blue. */
  public static byte[] toRgb(byte[] ycbcr) {
    byte[] result = new byte[ycbcr.length / 3 * 3];
    for (int i = 0; i + 2 < ycbcr.length; i += 3) {
      int y = (ycbcr[i] & 0xff) << 16;
      int cb = (ycbcr[i + 1] & 0xff) - 128;
      int cr = (ycbcr[i + 2] & 0xff) - 128;
      result[i] = clipped(y + 91881 * cr);
      result[i + 1] = clipped(y - 22554 * cb - 46802 * cr);
      result[i + 2] = clipped(y + 116130 * cb);
    }
    return result;
  }

  /** Red, green, blue to one byte of luminance for each pixel. */
  public static byte[] luminance(byte[] rgb) {
    byte[] result = new byte[rgb.length / 3];
    for (int i = 0; i < result.length; i++) {
      result[i] = luminance(rgb[3 * i] & 0xff, rgb[3 * i + 1] & 0xff, rgb[3 * i + 2] & 0xff);
    }
    return result;
  }

  private static byte luminance(int r, int g, int b) {
    return (byte) (19595 * r + 38470 * g + 7471 * b + HALF >> 16);
  }

  private static byte clipped(int fixed) {
    return (byte) Math.clamp(fixed + HALF >> 16, 0, 255);
  }
}
