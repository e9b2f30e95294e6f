package org.urbi.sim.vision;

import java.io.IOException;
import java.io.InputStream;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.net.JarURLConnection;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.opencv.core.Core;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.urbi.sim.SimulationException;

/**
 * Loads OpenCV's native libraries. Their 83 MB are unpacked once, into {@code
 * opencv-VERSION/PLATFORM} of the cache folder: {@code urbi.cache} if that system property is set,
 * {@code $XDG_CACHE_HOME/urbi}, or {@code ~/.cache/urbi}.
 */
public final class OpenCv {
  private static final String CACHE = "urbi.cache";

  /** Where the jars have the libraries: first those that the others need. */
  private static final List<String> FOLDERS =
      List.of("org/bytedeco/openblas/", "org/bytedeco/opencv/");

  /** A library, unless it is for JavaCPP's own bindings, which nobody uses here. */
  private static final Pattern LIBRARY =
      Pattern.compile("(?!lib/?jni|jni)[^/]+\\.(dll|dylib|so)(\\.\\d+)*");

  /** The library of the classes in {@code org.opencv}. */
  private static final String BINDINGS = "opencv_java";

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
      String platform =
          platform(System.getProperty("os.name", ""), System.getProperty("os.arch", ""));
      Path target = cacheFolder().resolve(Path.of("opencv-" + Core.VERSION, platform));
      List<Path> libraries = new ArrayList<>();
      for (String folder : FOLDERS) {
        libraries.addAll(unpacked(folder + platform + "/", target));
      }
      loadAll(libraries);
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
   * Loads libraries that need each other: one that cannot be loaded yet has another turn. Nobody
   * misses one that cannot be loaded at all and that the bindings do not need.
   */
  private static void loadAll(List<Path> libraries) throws IOException {
    Deque<Path> left = new ArrayDeque<>(libraries);
    int inVain = 0;
    while (!left.isEmpty()) {
      Path next = left.remove();
      try {
        loadForOpenCv(next);
        inVain = 0;
      } catch (UnsatisfiedLinkError e) {
        left.add(next);
        inVain++;
        if (inVain >= left.size()) {
          if (left.stream().anyMatch(each -> each.toString().contains(BINDINGS))) {
            throw e;
          }
          return;
        }
      }
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

  /** {@code linux-x86_64} and so on, as the jars have it. */
  static String platform(String system, String machine) {
    String os = system.toLowerCase(Locale.ROOT);
    String folder =
        os.startsWith("linux")
            ? "linux"
            : os.startsWith("mac") ? "macosx" : os.startsWith("windows") ? "windows" : null;
    String architecture =
        switch (machine.toLowerCase(Locale.ROOT)) {
          case "amd64", "x86_64" -> "x86_64";
          case "aarch64", "arm64" -> "arm64";
          default -> null;
        };
    if (folder == null || architecture == null) {
      throw new SimulationException("no OpenCV for " + system + " on " + machine);
    }
    return folder + "-" + architecture;
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

  private static List<Path> unpacked(String folder, Path target) throws IOException {
    URL url = OpenCv.class.getClassLoader().getResource(folder);
    if (url == null || !(url.openConnection() instanceof JarURLConnection connection)) {
      throw new SimulationException(
          "no OpenCV for this machine: install urbi-opencv (looked for " + folder + ")");
    }
    connection.setUseCaches(false);
    try (JarFile jar = connection.getJarFile()) {
      return unpacked(jar, folder, target);
    }
  }

  /** The libraries in a folder of a jar, written to another if missing or of another size. */
  static List<Path> unpacked(JarFile jar, String folder, Path target) throws IOException {
    Files.createDirectories(target);
    List<Path> all = new ArrayList<>();
    for (JarEntry each : Collections.list(jar.entries())) {
      String name = each.getName();
      if (name.startsWith(folder) && LIBRARY.matcher(name.substring(folder.length())).matches()) {
        Path file = target.resolve(name.substring(folder.length())).toAbsolutePath();
        if (!Files.exists(file) || Files.size(file) != each.getSize()) {
          try (InputStream input = jar.getInputStream(each)) {
            write(input, file);
          }
        }
        all.add(file);
      }
    }
    return all;
  }

  /** Others may be doing the same: each writes a file of its own, and the last one stays. */
  private static void write(InputStream input, Path file) throws IOException {
    Path draft = Files.createTempFile(file.getParent(), "unpacking", null);
    try {
      Files.copy(input, draft, StandardCopyOption.REPLACE_EXISTING);
      Files.move(draft, file, StandardCopyOption.ATOMIC_MOVE);
    } finally {
      Files.deleteIfExists(draft);
    }
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
