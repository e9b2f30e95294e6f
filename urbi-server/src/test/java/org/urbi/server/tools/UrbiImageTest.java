package org.urbi.server.tools;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.GraphicsEnvironment;
import java.awt.Window;
import java.awt.image.BufferedImage;
import java.lang.reflect.InvocationTargetException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import javax.imageio.ImageIO;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import urbi.UConversion;
import urbi.UImage;
import urbi.UImageFormat;

class UrbiImageTest {
  private static final int WIDTH = 32;
  private static final int HEIGHT = 16;

  @TempDir Path folder;
  private TestServer server;

  @BeforeEach
  void serve() throws Exception {
    server = new TestServer();
    server
        .kernel()
        .eval(
            """
            class Global.camera
            {
              var val = nil;
              var resolution = 3;
              var quality = 50;
            };
            """);
    setImage(new UImage(UImageFormat.IMAGE_RGB, WIDTH, HEIGHT, gradient()));
  }

  @AfterEach
  void close() {
    server.close();
  }

  /** Smooth, and different in each direction. */
  private static byte[] gradient() {
    byte[] rgb = new byte[3 * WIDTH * HEIGHT];
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
      rgb[3 * i] = (byte) (8 * (i % WIDTH));
      rgb[3 * i + 1] = (byte) (16 * (i / WIDTH));
      rgb[3 * i + 2] = 40;
    }
    return rgb;
  }

  private void setImage(UImage image) {
    StringBuilder bytes = new StringBuilder();
    for (byte b : image.getData()) {
      bytes.append(String.format("\\x%02x", b));
    }
    server
        .kernel()
        .eval(
            "camera.val = Binary.new(\"%s %d %d\", \"%s\") | {}"
                .formatted(image.format_string(), image.getWidth(), image.getHeight(), bytes));
  }

  private ToolResult fetch(String... options) {
    String[] all = Arrays.copyOf(options, options.length + 1);
    all[options.length] = server.port();
    return ToolResult.of(UrbiImage::run, all);
  }

  private byte[] saved(String file, String... options) throws Exception {
    String[] all = Arrays.copyOf(options, options.length + 1);
    all[options.length] = "--output=" + folder.resolve(file);
    ToolResult run = fetch(all);
    assertEquals(0, run.status(), run.err());
    assertEquals("", run.out());
    return Files.readAllBytes(folder.resolve(file));
  }

  @Test
  void imagesAreSavedInEachFormat() throws Exception {
    assertArrayEquals(gradient(), saved("rgb", "--format=rgb"));
    byte[] ppm = saved("image.ppm");
    byte[] header = ("P6\n" + WIDTH + " " + HEIGHT + "\n255\n").getBytes(StandardCharsets.US_ASCII);
    assertArrayEquals(header, Arrays.copyOf(ppm, header.length));
    assertArrayEquals(gradient(), Arrays.copyOfRange(ppm, header.length, ppm.length));
    assertArrayEquals(ppm, saved("other", "-F", "ppm"));
    assertArrayEquals(
        UConversion.convertRGBtoYCbCr(gradient()), saved("ycrcb", "--format", "ycrcb"));
    saved("image.jpg");
    BufferedImage read = ImageIO.read(folder.resolve("image.jpg").toFile());
    assertEquals(WIDTH, read.getWidth());
    assertEquals(8 * 20, read.getRGB(20, 5) >> 16 & 255, 12);
    assertEquals(16 * 5, read.getRGB(20, 5) >> 8 & 255, 12);
  }

  @Test
  void theFactorDecidesOnTheSizeOfAJpeg() throws Exception {
    int small = saved("small.jpg", "--jpeg=5").length;
    int usual = saved("usual.jpg").length;
    int large = saved("large.jpg", "-j", "100").length;
    assertTrue(small < usual && usual < large, small + " " + usual + " " + large);
    assertEquals(100, server.kernel().eval("camera.quality", double.class), "the device's, too");
  }

  @Test
  void jpegIsUnchangedUnlessAQualityIsGiven() throws Exception {
    byte[] jpeg = UConversion.convertRGBtoJPEG(gradient(), WIDTH, HEIGHT, 90);
    setImage(new UImage(UImageFormat.IMAGE_JPEG, WIDTH, HEIGHT, jpeg));
    assertArrayEquals(jpeg, saved("same.jpg"));
    assertTrue(saved("smaller.jpg", "--jpeg=10").length < jpeg.length);
    assertEquals(3 * WIDTH * HEIGHT, saved("rgb", "--format=rgb").length);
  }

  @Test
  void resolutionAndDeviceAreChosen() throws Exception {
    server.kernel().eval("var Global.eye = camera.new | eye.val = camera.val | camera.val = nil");
    assertArrayEquals(gradient(), saved("rgb", "-d", "eye", "-F", "rgb", "-R", "2"));
    assertEquals(2, server.kernel().eval("eye.resolution", double.class));
    assertEquals(3, server.kernel().eval("camera.resolution", double.class));
  }

  @Test
  void missingSlotOfTheDeviceIsReported() throws Exception {
    ToolResult run = fetch("--reconstruct", "-o", folder.resolve("a.jpg").toString());
    assertEquals(0, run.status());
    assertTrue(run.err().contains("camera has no slot reconstruct"), run.err());
    server.kernel().eval("var camera.reconstruct = 0");
    assertFalse(fetch("-r", "-o", folder.resolve("b.jpg").toString()).err().contains("no slot"));
    assertEquals(1, server.kernel().eval("camera.reconstruct", double.class));
  }

  private void fails(int status, String message, String... options) {
    ToolResult run = fetch(options);
    assertEquals(status, run.status(), run.err());
    assertTrue(run.err().startsWith("urbi-image: ") && run.err().contains(message), run.err());
  }

  @Test
  void mistakesAreReported() {
    String file = folder.resolve("x.jpg").toString();
    fails(1, "lookup failed: nobody", "--device=nobody", "-o", file);
    server.kernel().eval("camera.val = 12");
    fails(1, "camera.val is no image: ", "-o", file);
    setImage(new UImage(UImageFormat.IMAGE_RGB, WIDTH, HEIGHT, new byte[7]));
    fails(1, "camera.val cannot be converted: ", "-o", file);
    setImage(new UImage(UImageFormat.IMAGE_RGB, WIDTH, HEIGHT, gradient()));
    fails(1, "cannot write ", "-o", folder.resolve("no/such/folder/x.jpg").toString());
    fails(2, "invalid --format: gif (one of rgb, ycrcb, jpeg, ppm)", "-F", "gif", "-o", file);
    fails(2, "invalid --jpeg: 101 (a number from 0 to 100)", "-j", "101", "-o", file);
    fails(2, "invalid --scale: -1", "-s", "-1");
    fails(2, "invalid --period: 0", "-p", "0");
    assertFalse(Files.exists(Path.of(file)));
  }

  @Test
  void missingServerIsReported() throws Exception {
    server.close();
    ToolResult run = fetch("-o", folder.resolve("x.jpg").toString());
    assertEquals(1, run.status());
    assertTrue(run.err().contains("cannot connect to 127.0.0.1:"), run.err());
    server = new TestServer();
  }

  @Test
  void missingDisplayIsReportedWithAHint() {
    assumeTrue(GraphicsEnvironment.isHeadless(), "skipped: this machine has a display");
    fails(1, "no display to show images on: --output=FILE saves one instead");
  }

  @Test
  void imagesAreShownUntilTheWindowIsClosed() throws Exception {
    assumeTrue(!GraphicsEnvironment.isHeadless(), "skipped: this machine has no display");
    CompletableFuture<Integer> width = CompletableFuture.supplyAsync(UrbiImageTest::closeWindow);
    ToolResult run = fetch("--scale=2", "--period=20");
    assertEquals(0, run.status(), run.err());
    assertEquals(2 * WIDTH, width.join());
  }

  /** Waits for a window, closes it and returns how wide its content was. */
  private static int closeWindow() {
    int[] width = new int[1];
    try {
      while (width[0] == 0) {
        Thread.sleep(20);
        SwingUtilities.invokeAndWait(() -> {
          for (Window window : Window.getWindows()) {
            if (window instanceof JFrame frame && frame.isShowing()) {
              width[0] = frame.getContentPane().getWidth();
              frame.dispose();
            }
          }
        });
      }
    } catch (InterruptedException | InvocationTargetException e) {
      throw new AssertionError(e);
    }
    return width[0];
  }
}
