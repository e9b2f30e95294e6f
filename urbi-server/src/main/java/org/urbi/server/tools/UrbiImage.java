package org.urbi.server.tools;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;
import urbi.UCastException;
import urbi.UClientException;
import urbi.UConversion;
import urbi.UConversionException;
import urbi.UImage;
import urbi.UImageFormat;
import urbi.USyncClient;

/**
 * The program {@code urbi-image}: fetches images from a device of a running server, and shows them
 * in a window or saves one (manual, section 21.4).
 */
public final class UrbiImage {
  private static final String DEFAULT_DEVICE = "camera";
  private static final int DEFAULT_PERIOD = 100;
  private static final int DEFAULT_QUALITY = 70;
  private static final int BEST_QUALITY = 100;
  private static final double MAX_SCALE = 16;
  private static final Duration TIMEOUT = Duration.ofSeconds(20);
  private static final List<String> FORMATS = List.of("rgb", "ycrcb", "jpeg", "ppm");

  private final PrintStream err;

  private UrbiImage(PrintStream err) {
    this.err = err;
  }

  public static void main(String[] args) {
    System.exit(run(args, System.out, System.err));
  }

  /** Runs the program and returns its exit status. */
  public static int run(String[] args, PrintStream out, PrintStream err) {
    Program program = new Program("urbi-image", "Shows or saves images of a running Urbi server.");
    return ServerAddress.options(program)
        .option(
            "PERIOD",
            "Milliseconds from one image to the next (default: " + DEFAULT_PERIOD + ").",
            "-p",
            "--period")
        .option(
            "FORMAT",
            "Format of the image: " + String.join(", ", FORMATS) + " (default: as FILE, or jpeg).",
            "-F",
            "--format")
        .flag("Have the device reconstruct its images (Aibo).", "-r", "--reconstruct")
        .option(
            "FACTOR",
            "JPEG compression factor, 0 to 100 (default: " + DEFAULT_QUALITY + ").",
            "-j",
            "--jpeg")
        .option(
            "DEVICE",
            "Query images on DEVICE.val (default: " + DEFAULT_DEVICE + ").",
            "-d",
            "--device")
        .option("FILE", "Query one image and save it to FILE.", "-o", "--output")
        .option("RESOLUTION", "Resolution of the image (0: biggest).", "-R", "--resolution")
        .option("FACTOR", "Show images larger or smaller by FACTOR.", "-s", "--scale")
        .run(args, out, err, new UrbiImage(err)::work);
  }

  private int work(Arguments arguments) {
    String device = arguments.value("--device", DEFAULT_DEVICE);
    Path file = arguments.has("--output") ? Path.of(arguments.value("--output", "")) : null;
    UImageFormat format = format(arguments, file);
    int quality = arguments.number("--jpeg", DEFAULT_QUALITY, 0, BEST_QUALITY);
    int period = arguments.number("--period", DEFAULT_PERIOD, 1, Integer.MAX_VALUE);
    double scale = scale(arguments);
    int resolution = arguments.number("--resolution", 0, 0, Integer.MAX_VALUE);
    ServerAddress target = ServerAddress.of(arguments, arguments.value("--host", "127.0.0.1"));
    try (ImageWindow window =
            file == null ? ImageWindow.open(device + " – " + target, scale) : null;
        USyncClient client = target.client()) {
      if (arguments.has("--resolution")) {
        client.syncGet(TIMEOUT, device + ".resolution = " + resolution);
      }
      if (arguments.has("--reconstruct")) {
        setIfThere(client, device, "reconstruct", 1);
      }
      if (arguments.has("--jpeg")) {
        setIfThere(client, device, "quality", quality);
      }
      if (file != null) {
        boolean asked = arguments.has("--jpeg");
        save(converted(fetch(client, device), format, asked ? quality : -1), file);
      } else {
        show(client, device, period, requireNonNull(window, "opened as there is no file"));
      }
      return 0;
    } catch (UClientException e) {
      throw Failure.of(e.getMessage());
    } catch (UConversionException e) {
      throw Failure.of(device + ".val cannot be converted: " + e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return 0;
    }
  }

  private static UImageFormat format(Arguments arguments, @Nullable Path file) {
    String word = arguments.value("--format");
    if (word == null) {
      String name = file == null ? "" : file.toString().toLowerCase(Locale.ROOT);
      return name.endsWith(".ppm") ? UImageFormat.IMAGE_PPM : UImageFormat.IMAGE_JPEG;
    }
    if (!FORMATS.contains(word.toLowerCase(Locale.ROOT))) {
      throw Failure.usage(
          "invalid --format: " + word + " (one of " + String.join(", ", FORMATS) + ")");
    }
    return UImageFormat.parse(word);
  }

  private static double scale(Arguments arguments) {
    String text = arguments.value("--scale", "1");
    try {
      double scale = Double.parseDouble(text);
      if (scale > 0 && scale <= MAX_SCALE) {
        return scale;
      }
    } catch (NumberFormatException e) {
      // Answered below, like a number that is out of range.
    }
    throw Failure.usage("invalid --scale: " + text + " (a number, up to " + MAX_SCALE + ")");
  }

  /** Sets a slot of the device if it exists: not every camera has all of them. */
  private void setIfThere(USyncClient client, String device, String slot, int value) {
    String code =
        "if (%1$s.hasSlot(\"%2$s\")) { %1$s.%2$s = %3$d | 1 } else 0"
            .formatted(device, slot, value);
    if (client.syncGet(TIMEOUT, code).getValue().intValue() == 0) {
      err.println("urbi-image: " + device + " has no slot " + slot + ", left as it is");
    }
  }

  private static UImage fetch(USyncClient client, String device) {
    try {
      return client.syncEval(device + ".val", TIMEOUT).uimageValue();
    } catch (UCastException e) {
      throw Failure.of(device + ".val is no image: " + e.getMessage());
    }
  }

  /**
   * An image in another format.
   *
   * @param quality of JPEG; -1 to leave one as it is, and for the usual one otherwise
   */
  private static UImage converted(UImage image, UImageFormat format, int quality) {
    boolean jpeg = format == UImageFormat.IMAGE_JPEG;
    if (image.getImageFormat() == format && !(jpeg && quality >= 0)) {
      return image;
    }
    UImage converted = new UImage();
    converted.setImageFormat(jpeg ? UImageFormat.IMAGE_RGB : format);
    UConversion.convert(image, converted);
    if (!jpeg) {
      return converted;
    }
    int width = converted.getWidth();
    int height = converted.getHeight();
    int used = quality >= 0 ? quality : DEFAULT_QUALITY;
    return new UImage(
        format,
        width,
        height,
        UConversion.convertRGBtoJPEG(converted.getData(), width, height, used));
  }

  private void save(UImage image, Path file) {
    try {
      Files.write(file, image.getData());
    } catch (IOException e) {
      throw Failure.of("cannot write " + file + ": " + e);
    }
    err.println(
        "urbi-image: %s: %s, %d x %d"
            .formatted(file, image.format_string(), image.getWidth(), image.getHeight()));
  }

  private static void show(USyncClient client, String device, int period, ImageWindow window)
      throws InterruptedException {
    while (window.isOpen()) {
      window.show(converted(fetch(client, device), UImageFormat.IMAGE_RGB, -1));
      Thread.sleep(period);
    }
  }
}
