package org.urbi.sim.vision;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.abort;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.jar.JarOutputStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.sim.SimulationException;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Rotation;
import org.urbi.sim.geometry.Shape;
import org.urbi.sim.geometry.Vec3;
import org.urbi.sim.render.Appearance;
import org.urbi.sim.render.Colour;
import org.urbi.sim.render.Lens;
import org.urbi.sim.render.Light;
import org.urbi.sim.render.Renderer;
import org.urbi.sim.render.Scene;
import org.urbi.sim.render.SceneObject;
import urbi.UConversion;
import urbi.UImage;
import urbi.UImageFormat;

/** Skipped where OpenCV has no native library for the machine. */
class VisionTest {
  private static final int WIDTH = 320;
  private static final int HEIGHT = 240;
  private static final Lens LENS = new Lens(WIDTH, HEIGHT, 1, 0.02, 100);

  @BeforeAll
  static void openCv() {
    try {
      OpenCv.require();
    } catch (SimulationException e) {
      abort("skipped: " + e.getMessage());
    }
  }

  private static byte[] picture(SceneObject... things) {
    return new Renderer()
        .render(
            new Scene(
                List.of(things),
                List.of(new Light.Sun(new Vec3(0.5, 0.3, -1), new Colour(0.6, 0.6, 0.6))),
                0.4,
                new Colour(0.6, 0.75, 0.95)),
            Pose.ORIGIN,
            LENS);
  }

  private static SceneObject ball(double x, double y, double z, double radius, Colour colour) {
    return new SceneObject(
        new Shape.Sphere(radius), Pose.at(x, y, z), new Appearance(colour, null, 1, 0.3, 0));
  }

  private static final Colour RED = new Colour(0.9, 0.1, 0.1);
  private static final Colour BLUE = new Colour(0.1, 0.2, 0.9);

  @Test
  void ballIsFoundWhereItIs() {
    BlobFinder finder = new BlobFinder();
    double focal = LENS.focalLength();
    for (double[] place : new double[][] {{1, 0.2, 0.1}, {2, -0.5, -0.3}, {1.5, 0, 0}}) {
      byte[] rgb =
          picture(ball(place[0], place[1], place[2], 0.1, RED), ball(3, 0.4, 0.4, 0.2, BLUE));
      Blob blob = finder.find(rgb, WIDTH, HEIGHT, ColourRange.RED, 0).orElseThrow();
      assertEquals(-place[1] / place[0] * focal / WIDTH, blob.x(), 0.006);
      assertEquals(place[2] / place[0] * focal / HEIGHT, blob.y(), 0.006);
      double radius = 0.1 / place[0] * focal;
      assertEquals(radius, blob.radius(), 0.1 * radius + 1);
      assertEquals(Math.PI * radius * radius / WIDTH / HEIGHT, blob.ratio(), 0.2 * blob.ratio());
      assertEquals(1, blob.elongation(), 0.15);
    }
  }

  @Test
  void nothingIsFoundInAnEmptyImage() {
    BlobFinder finder = new BlobFinder();
    byte[] rgb = picture(ball(2, 0, 0, 0.1, BLUE));
    assertTrue(finder.find(rgb, WIDTH, HEIGHT, ColourRange.RED, 0).isEmpty());
    rgb = picture(ball(2, 0, 0, 0.1, RED));
    assertTrue(finder.find(rgb, WIDTH, HEIGHT, ColourRange.RED, 0.5).isEmpty(), "too small");
    // A single pixel has a contour without an area.
    byte[] dot = new byte[3 * WIDTH * HEIGHT];
    dot[3 * 5000] = (byte) 255;
    assertTrue(finder.find(dot, WIDTH, HEIGHT, ColourRange.RED, 0).isEmpty());
  }

  @Test
  void barHasADirection() {
    Pose pose = new Pose(new Vec3(1, 0, 0), Rotation.about(Vec3.X, Math.PI / 6));
    byte[] rgb = picture(new SceneObject(new Shape.Box(0.02, 0.4, 0.1), pose, Appearance.of(RED)));
    Blob blob = new BlobFinder().find(rgb, WIDTH, HEIGHT, ColourRange.RED, 0).orElseThrow();
    assertEquals(4, blob.elongation(), 0.3);
    // Turned about the axis away from the camera: its left end, which is +y, went up.
    assertEquals(-Math.PI / 6, blob.orientation(), 0.02);
  }

  @Test
  void colourMapNamesPixels() {
    byte[] rgb = picture(ball(1, 0.2, 0, 0.1, RED), ball(1, -0.2, 0, 0.1, BLUE));
    ColourMap map = new ColourMap();
    map.define("red", ColourRange.RED, new Colour(1, 0, 0));
    map.define("blue", new ColourRange(220, 250, 0.6, 1, 0.1, 1), new Colour(0, 0, 1));
    assertEquals(List.of("red", "blue"), map.names());
    Map<String, Double> shares = map.shares(rgb, WIDTH, HEIGHT);
    double disc = Math.PI * Math.pow(0.1 * LENS.focalLength(), 2) / WIDTH / HEIGHT;
    assertEquals(disc, shares.get("red"), 0.15 * disc);
    assertEquals(disc, shares.get("blue"), 0.15 * disc);
    byte[] classes = map.classify(rgb, WIDTH, HEIGHT);
    byte[] painted = map.paint(rgb, WIDTH, HEIGHT);
    int left = 120 * WIDTH + 160 - (int) (0.2 * LENS.focalLength());
    assertEquals(1, classes[left]);
    assertEquals(255, painted[3 * left] & 255);
    assertEquals(0, classes[0]);
    assertTrue(map.forget("red"));
    assertEquals(List.of("blue"), map.names());
  }

  @Test
  void filtersDoWhatTheySay() {
    byte[] rgb = picture(ball(1, 0, 0, 0.1, RED));
    int middle = 3 * (120 * WIDTH + 160);
    for (ImageFilter.Kind kind : ImageFilter.Kind.values()) {
      assertEquals(
          rgb.length, new ImageFilter(kind).apply(rgb, WIDTH, HEIGHT).length, kind.urbiName());
    }
    byte[] inverted = filtered("invert", 0, rgb);
    assertEquals(255 - (rgb[middle] & 255), inverted[middle] & 255);
    assertArrayEquals(rgb, filtered("mirror", 0, filtered("mirror", 0, rgb)));
    byte[] flipped = filtered("flip", 0, rgb);
    assertEquals(rgb[3], flipped[3 * (239 * WIDTH + 1)]);
    assertEquals(
        UConversion.convertRGBtoGrey8_601(rgb)[middle / 3] & 255,
        filtered("grey", 0, rgb)[middle] & 255,
        1);
    byte[] edges = filtered("edges", 0.2, rgb);
    assertEquals(0, edges[middle], "inside the ball");
    int white = 0;
    for (int i = 0; i < edges.length; i += 3) {
      white += edges[i] != 0 ? 1 : 0;
    }
    double contour = 2 * Math.PI * 0.1 * LENS.focalLength();
    assertTrue(white > 0.5 * contour && white < 3 * contour, white + " of " + contour);
    ImageFilter difference = new ImageFilter(ImageFilter.Kind.DIFFERENCE);
    difference.apply(rgb, WIDTH, HEIGHT);
    byte[] moved = difference.apply(picture(ball(1, 0.3, 0, 0.1, RED)), WIDTH, HEIGHT);
    assertTrue((moved[middle + 1] & 255) > 50, "where it was");
    assertEquals(0, moved[0]);
  }

  private static byte[] filtered(String name, double parameter, byte[] rgb) {
    ImageFilter filter = new ImageFilter(ImageFilter.Kind.named(name));
    if (parameter > 0) {
      filter.setParameter(parameter);
    }
    return filter.apply(rgb, WIDTH, HEIGHT);
  }

  @Test
  void nonsenseIsRefused() {
    refused(
        "unknown filter 'magic'; there are grey, invert, mirror, flip, blur, median, threshold,"
            + " edges, gradient, erode, dilate, equalize, difference",
        () -> ImageFilter.Kind.named("magic"));
    ImageFilter blur = new ImageFilter(ImageFilter.Kind.BLUR);
    refused(
        "blur: parameter between 0.5 and 50.0 expected, not NaN",
        () -> blur.setParameter(Double.NaN));
    refused(
        "an image of 320x240 pixels has 230400 bytes, not 5",
        () -> blur.apply(new byte[5], WIDTH, HEIGHT));
    refused(
        "saturation: a range between 0 and 1 expected, not 0.5 to 0.2",
        () -> new ColourRange(0, 1, 0.5, 0.2, 0, 1));
    refused("no OpenCV for Plan 9 on amd64", () -> OpenCv.platform("Plan 9", "amd64"));
  }

  private static void refused(String message, org.junit.jupiter.api.function.Executable wrong) {
    assertEquals(message, assertThrows(SimulationException.class, wrong).getMessage());
  }

  @Test
  void codersAgreeWithThoseOfUObjects() {
    byte[] rgb = picture(ball(1, 0, 0, 0.2, RED), ball(1, 0.3, 0.2, 0.1, BLUE));
    byte[] mine = ImageCoder.yCbCr(rgb, WIDTH, HEIGHT);
    byte[] theirs = UConversion.convertRGBtoYCbCr(rgb);
    for (int i = 0; i < mine.length; i++) {
      assertEquals(theirs[i] & 255, mine[i] & 255, 2);
    }
    UImage jpeg = ImageCoder.encode(rgb, WIDTH, HEIGHT, UImageFormat.IMAGE_JPEG, 95);
    UImage back = ImageCoder.toRgb(jpeg);
    assertEquals(WIDTH, back.getWidth());
    long error = 0;
    for (int i = 0; i < rgb.length; i++) {
      error += Math.abs((rgb[i] & 255) - (back.getData()[i] & 255));
    }
    assertTrue((double) error / rgb.length < 3, "mean error " + (double) error / rgb.length);
    assertTrue(
        ImageCoder.jpeg(rgb, WIDTH, HEIGHT, 20).length < jpeg.getSize() / 2, "lower quality");
  }

  @Test
  void libraryIsUnpackedOnce(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("natives.jar");
    try (JarOutputStream jar = new JarOutputStream(Files.newOutputStream(file))) {
      for (String name : List.of("libone.so.4", "libjnione.so", "include/one.so", "one.xml")) {
        jar.putNextEntry(new JarEntry("natives/test/" + name));
        jar.write("one".getBytes(StandardCharsets.US_ASCII));
        jar.closeEntry();
      }
    }
    Path cache = folder.resolve("cache/platform");
    try (JarFile jar = new JarFile(file.toFile())) {
      List<Path> all = OpenCv.unpacked(jar, "natives/test/", cache);
      Path only = cache.resolve("libone.so.4").toAbsolutePath();
      assertEquals(List.of(only), all);
      assertEquals("one", Files.readString(only));
      Files.writeString(only, "two");
      assertEquals(all, OpenCv.unpacked(jar, "natives/test/", cache));
      assertEquals("two", Files.readString(only), "of the same size");
      Files.writeString(only, "broken");
      OpenCv.unpacked(jar, "natives/test/", cache);
      assertEquals("one", Files.readString(only));
      try (var files = Files.list(cache)) {
        assertEquals(1, files.count(), "nothing else stays");
      }
    }
  }
}
