package org.urbi.sim.vision;

import java.io.IOException;
import java.io.InputStream;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.net.URL;
import java.net.URLConnection;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.opencv.core.Core;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.urbi.sim.SimulationException;

/**
 * Loads OpenCV's native library. Its 60 MB are unpacked once, into {@code opencv-VERSION/PLATFORM}
 * of the cache folder: {@code urbi.cache} if that system property is set, {@code
 * $XDG_CACHE_HOME/urbi}, or {@code ~/.cache/urbi}.
 */
public final class OpenCv {
  private static final String CACHE = "urbi.cache";

  private static boolean loaded;
  private static @Nullable SimulationException failure;

  private OpenCv() {}

  /**
   * Has it loaded.
   *
   * @throws SimulationException if there is none for this machine, or if it cannot be unpacked
   */
  public static synchronized void require() {
    if (loaded) {
      return;
    }
    if (failure == null) {
      failure = load();
    }
    if (failure != null) {
      throw new SimulationException(failure.getMessage(), failure);
    }
    loaded = true;
  }

  /** Whether it can be used. */
  public static boolean isAvailable() {
    try {
      require();
      return true;
    } catch (SimulationException e) {
      return false;
    }
  }

  private static @Nullable SimulationException load() {
    try {
      Path library = unpacked(resource(), cacheFolder());
      loadForOpenCv(library);
      // One thread: what is computed is the same everywhere, and small images gain nothing.
      Core.setNumThreads(1);
      return null;
    } catch (SimulationException e) {
      return e;
    } catch (IOException e) {
      return new SimulationException("OpenCV cannot be unpacked: " + e, e);
    } catch (LinkageError e) {
      return new SimulationException("OpenCV cannot be loaded: " + e.getMessage(), e);
    }
  }

  /**
   * A library is that of the class loader which loads it, and that has to be the one of OpenCV's
   * classes: components have a class loader of their own.
   */
  private static void loadForOpenCv(Path library) throws IOException {
    try {
      Class<?> loader = libraryLoader();
      MethodHandles.privateLookupIn(loader, MethodHandles.lookup())
          .findStatic(loader, "load", MethodType.methodType(void.class, String.class))
          .invokeExact(library.toString());
    } catch (Error | RuntimeException | IOException e) {
      throw e;
    } catch (Throwable e) {
      throw new SimulationException("OpenCV cannot be loaded: " + e, e);
    }
  }

  private static Class<?> libraryLoader() throws IOException, IllegalAccessException {
    String name = Core.class.getPackageName() + ".LibraryLoader";
    try {
      return Class.forName(name, true, Core.class.getClassLoader());
    } catch (ClassNotFoundException e) {
      try (InputStream own =
          OpenCv.class.getResourceAsStream("/" + name.replace('.', '/') + ".class")) {
        return MethodHandles.privateLookupIn(Core.class, MethodHandles.lookup())
            .defineClass(own.readAllBytes());
      }
    }
  }

  /** {@code linux/x86_64} and so on, as the jar has it. */
  static String platform(String system, String machine) {
    String os = system.toLowerCase(Locale.ROOT);
    String folder =
        os.startsWith("linux")
            ? "linux"
            : os.startsWith("mac") ? "osx" : os.startsWith("windows") ? "windows" : null;
    String architecture =
        switch (machine.toLowerCase(Locale.ROOT)) {
          case "amd64", "x86_64" -> "x86_64";
          case "aarch64", "arm64" -> "ARMv8";
          case "arm" -> "ARMv7";
          case "x86", "i386", "i686" -> "x86_32";
          default -> null;
        };
    if (folder == null || architecture == null) {
      throw new SimulationException("no OpenCV for " + system + " on " + machine);
    }
    return folder + "/" + architecture;
  }

  private static URL resource() {
    String platform = platform(System.getProperty("os.name"), System.getProperty("os.arch"));
    String file = System.mapLibraryName(Core.NATIVE_LIBRARY_NAME);
    URL url = OpenCv.class.getResource("/nu/pattern/opencv/" + platform + "/" + file);
    if (url == null) {
      throw new SimulationException("no OpenCV for this machine (" + platform + ")");
    }
    return url;
  }

  static Path cacheFolder() {
    String own = System.getProperty(CACHE);
    if (own != null) {
      return Path.of(own);
    }
    String xdg = System.getenv("XDG_CACHE_HOME");
    return xdg != null && Path.of(xdg).isAbsolute()
        ? Path.of(xdg, "urbi")
        : Path.of(System.getProperty("user.home"), ".cache", "urbi");
  }

  /** The file in the cache, written if it is missing or of another size. */
  static Path unpacked(URL source, Path cache) throws IOException {
    String path = source.getPath();
    String[] steps = path.substring(path.indexOf("nu/pattern/")).split("/");
    Path target =
        cache.resolve(Path.of("opencv-" + Core.VERSION, steps[3] + "-" + steps[4], steps[5]));
    URLConnection connection = source.openConnection();
    connection.setUseCaches(false);
    try (InputStream input = connection.getInputStream()) {
      if (!Files.exists(target) || Files.size(target) != connection.getContentLengthLong()) {
        Files.createDirectories(target.getParent());
        // Others may be doing the same: each writes a file of its own, and the last one stays.
        Path draft = Files.createTempFile(target.getParent(), "unpacking", null);
        try {
          Files.copy(input, draft, StandardCopyOption.REPLACE_EXISTING);
          Files.move(draft, target, StandardCopyOption.ATOMIC_MOVE);
        } finally {
          Files.deleteIfExists(draft);
        }
      }
    }
    return target.toAbsolutePath();
  }

  /**
   * An image as OpenCV's matrix.
   *
   * @param rgb three bytes for each pixel
   * @throws SimulationException if there are not as many bytes as that
   */
  static Mat matrix(byte[] rgb, int width, int height) {
    require();
    if (width <= 0 || height <= 0 || rgb.length != 3L * width * height) {
      throw new SimulationException(
          "an image of "
              + width
              + "x"
              + height
              + " pixels has "
              + 3L * width * height
              + " bytes, not "
              + rgb.length);
    }
    Mat matrix = new Mat(height, width, CvType.CV_8UC3);
    matrix.put(0, 0, rgb);
    return matrix;
  }

  /** The bytes of a matrix. */
  static byte[] bytes(Mat matrix) {
    byte[] bytes = new byte[(int) (matrix.total() * matrix.elemSize())];
    matrix.get(0, 0, bytes);
    return bytes;
  }
}
