package urbi.media;

import java.util.concurrent.Callable;

/** JPEG files, and a clear word where this Java has no module {@code java.desktop}. */
final class Jpeg {
  private Jpeg() {}

  static Pixels decode(byte[] data) {
    return guarded(() -> JpegCodec.decode(data));
  }

  static byte[] encode(Pixels rgb, int quality) {
    return guarded(() -> JpegCodec.encode(rgb, quality));
  }

  private static <T> T guarded(Callable<T> action) {
    try {
      return action.call();
    } catch (MediaException e) {
      throw e;
    } catch (LinkageError e) {
      throw new MediaException(
          "JPEG images need the module java.desktop, which this Java does not have", e);
    } catch (Exception e) {
      throw new MediaException("no JPEG file, or a broken one: " + e.getMessage(), e);
    }
  }
}
