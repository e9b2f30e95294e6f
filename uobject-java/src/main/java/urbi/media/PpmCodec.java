package urbi.media;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** PPM files, variant P6, 8 bits. */
final class PpmCodec {
  private final byte[] data;
  private int at;

  private PpmCodec(byte[] data) {
    this.data = data;
  }

  static byte[] encode(Pixels rgb) {
    byte[] header =
        ("P6\n" + rgb.width() + " " + rgb.height() + "\n255\n").getBytes(StandardCharsets.US_ASCII);
    byte[] result = Arrays.copyOf(header, header.length + rgb.data().length);
    System.arraycopy(rgb.data(), 0, result, header.length, rgb.data().length);
    return result;
  }

  static Pixels decode(byte[] data) {
    return new PpmCodec(data).read();
  }

  private Pixels read() {
    if (data.length < 3 || data[0] != 'P' || data[1] != '6') {
      throw new MediaException("no PPM file: it does not start with P6");
    }
    at = 2;
    int width = number();
    int height = number();
    int most = number();
    if (most != 255) {
      throw new MediaException("a PPM file with " + most + " shades, not 255");
    }
    at++;
    byte[] pixels = Arrays.copyOfRange(data, Math.min(at, data.length), data.length);
    Pixels.requireSize("ppm", width, height, pixels, 3L * width * height);
    return new Pixels(width, height, false, pixels);
  }

  private int number() {
    while (at < data.length && (data[at] <= ' ' || data[at] == '#')) {
      if (data[at] == '#') {
        while (at < data.length && data[at] != '\n') {
          at++;
        }
      } else {
        at++;
      }
    }
    int value = 0;
    int start = at;
    while (at < data.length && '0' <= data[at] && data[at] <= '9' && at - start < 7) {
      value = 10 * value + data[at++] - '0';
    }
    if (at == start) {
      throw new MediaException("a PPM file's header is not complete");
    }
    return value;
  }
}
