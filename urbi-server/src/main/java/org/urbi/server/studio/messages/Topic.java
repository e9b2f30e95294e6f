package org.urbi.server.studio.messages;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.observe.Bytes;
import org.urbi.kernel.observe.VariableKind;
import urbi.UBinary;
import urbi.UCastException;
import urbi.UImage;
import urbi.media.ImageFormat;
import urbi.media.MediaException;
import urbi.media.Picture;

/**
 * A sequence of messages of one kind: those of a variable, of the log, of the jobs, or of their
 * turns. They are JSON objects, with a JSON schema.
 *
 * @param path the name of the variable
 * @param kind of its values
 */
public record Topic(String path, VariableKind kind) {
  private static final long SECOND = 1_000_000_000;
  private static final int QUALITY = 80;

  private static final String TIMESTAMP =
      "\"timestamp\":{\"type\":\"object\",\"title\":\"time\",\"properties\":{"
          + "\"sec\":{\"type\":\"integer\",\"minimum\":0},"
          + "\"nsec\":{\"type\":\"integer\",\"minimum\":0,\"maximum\":999999999}}},";

  private static final String IMAGE =
      "{\"title\":\"foxglove.CompressedImage\",\"type\":\"object\",\"properties\":{"
          + TIMESTAMP
          + "\"frame_id\":{\"type\":\"string\"},"
          + "\"data\":{\"type\":\"string\",\"contentEncoding\":\"base64\"},"
          + "\"format\":{\"type\":\"string\"}}}";

  private static final String LOG_SCHEMA =
      "{\"title\":\"foxglove.Log\",\"type\":\"object\",\"properties\":{"
          + TIMESTAMP
          + "\"level\":{\"type\":\"integer\"},"
          + "\"message\":{\"type\":\"string\"},"
          + "\"name\":{\"type\":\"string\"},"
          + "\"file\":{\"type\":\"string\"},"
          + "\"line\":{\"type\":\"integer\",\"minimum\":0}}}";

  /** What the kernel logs; no variable has that path. */
  public static final Topic LOG = new Topic("/log", VariableKind.TEXT);

  private static final String TEXT = "{\"type\":\"string\"}";

  private static final String JOBS_SCHEMA =
      "{\"title\":\"urbi.Jobs\",\"type\":\"object\",\"properties\":{"
          + "\"total\":{\"type\":\"integer\"},"
          + "\"jobs\":{\"type\":\"array\",\"items\":{\"type\":\"object\",\"properties\":{"
          + "\"number\":{\"type\":\"integer\"},\"starter\":{\"type\":\"integer\"},"
          + "\"share\":{\"type\":\"number\"},\"frozen\":{\"type\":\"boolean\"},"
          + "\"tags\":{\"type\":\"array\",\"items\":"
          + TEXT
          + "},"
          + Stream.of("name", "lobby", "waits", "place", "code")
              .map(each -> '"' + each + "\":" + TEXT)
              .collect(Collectors.joining(","))
          + "}}}}}";

  /** The jobs that there are; no variable has that path. */
  public static final Topic JOBS = new Topic("/jobs", VariableKind.DICTIONARY);

  private static final String NUMBER = "{\"type\":\"number\"}";
  private static final String INTEGER = "{\"type\":\"integer\"}";

  private static final String TURNS_SCHEMA =
      "{\"title\":\"urbi.Turns\",\"type\":\"object\",\"properties\":{\"machine\":"
          + NUMBER
          + ",\"lostUntil\":"
          + NUMBER
          + ",\"traced\":{\"type\":\"array\",\"items\":{\"type\":\"object\",\"properties\":{\"job\":"
          + INTEGER
          + ",\"since\":"
          + NUMBER
          + "}}},\"turns\":{\"type\":\"array\",\"items\":{\"type\":\"object\",\"properties\":{\"job\":"
          + INTEGER
          + ",\"begin\":"
          + NUMBER
          + ",\"end\":"
          + NUMBER
          + ",\"waited\":"
          + TEXT
          + ",\"wakers\":{\"type\":\"array\",\"items\":"
          + INTEGER
          + "},\"ended\":{\"type\":\"boolean\"}}}}}}";

  /** The turns that jobs have had; no variable has that path. */
  public static final Topic TURNS = new Topic("/turns", VariableKind.DICTIONARY);

  private static final int INFO = 2;
  private static final int WARNING = 3;
  private static final int ERROR = 4;

  /** Its name, as those who look at it write it: {@code /robot/body/x}. */
  public String name() {
    return isOfKernel() ? path : "/" + path.replace('.', '/');
  }

  /** Whether it tells of the kernel itself: other topics are variables. */
  private boolean isOfKernel() {
    return path.startsWith("/");
  }

  private boolean isLog() {
    return path.equals(LOG.path);
  }

  /** The path of the slot for which a topic of that name stands. */
  public static String path(String name) {
    return name.replaceFirst("^/", "").replace('/', '.');
  }

  /** Whether its values can be parameters: they are small, and can be written by people. */
  public boolean isParameter() {
    return switch (kind) {
      case IMAGE, BINARY, ANY -> false;
      default -> !isOfKernel();
    };
  }

  /** The name of its schema. */
  public String schemaName() {
    if (isLog()) {
      return "foxglove.Log";
    }
    if (equals(JOBS)) {
      return "urbi.Jobs";
    }
    if (equals(TURNS)) {
      return "urbi.Turns";
    }
    return kind == VariableKind.IMAGE
        ? "foxglove.CompressedImage"
        : "urbi." + kind.name().charAt(0) + kind.name().substring(1).toLowerCase(Locale.ROOT);
  }

  /** Its JSON schema. */
  public String schema() {
    if (isLog()) {
      return LOG_SCHEMA;
    }
    if (equals(JOBS)) {
      return JOBS_SCHEMA;
    }
    if (equals(TURNS)) {
      return TURNS_SCHEMA;
    }
    if (kind == VariableKind.IMAGE) {
      return IMAGE;
    }
    String value =
        switch (kind) {
          case NUMBER -> "{\"type\":\"number\"}";
          case BOOLEAN -> "{\"type\":\"boolean\"}";
          case TEXT -> "{\"type\":\"string\"}";
          case NUMBERS -> "{\"type\":\"array\",\"items\":{\"type\":\"number\"}}";
          case LIST -> "{\"type\":\"array\"}";
          case DICTIONARY -> "{\"type\":\"object\"}";
          case BINARY ->
              "{\"type\":\"object\",\"properties\":{\"keywords\":{\"type\":\"string\"},"
                  + "\"data\":{\"type\":\"string\",\"contentEncoding\":\"base64\"}}}";
          default -> "{}";
        };
    return "{\"title\":\""
        + schemaName()
        + "\",\"type\":\"object\",\"properties\":{\"value\":"
        + value
        + "}}";
  }

  /**
   * A message.
   *
   * @param time in nanoseconds since the Epoch
   * @param value as a {@link org.urbi.kernel.observe.VariableListener} is told it; for the log, the
   *     line
   */
  public byte[] message(long time, @Nullable Object value) {
    if (isLog()) {
      String line = String.valueOf(value);
      return Json.object(out -> writeLog(out, time, line));
    }
    if (kind == VariableKind.IMAGE && value instanceof Bytes image) {
      return Json.object(out -> writeImage(out, time, image));
    }
    if ((equals(JOBS) || equals(TURNS)) && value instanceof Map<?, ?> content) {
      return Json.object(content);
    }
    return Json.object(out -> {
      out.writeFieldName("value");
      Json.write(out, value);
    });
  }

  private static void writeTime(JsonGenerator out, long time) throws IOException {
    out.writeObjectFieldStart("timestamp");
    out.writeNumberField("sec", Math.floorDiv(time, SECOND));
    out.writeNumberField("nsec", Math.floorMod(time, SECOND));
    out.writeEndObject();
  }

  private static void writeLog(JsonGenerator out, long time, String line) throws IOException {
    writeTime(out, time);
    out.writeNumberField("level", level(line));
    out.writeStringField("message", line);
    out.writeStringField("name", "urbi");
    out.writeStringField("file", "");
    out.writeNumberField("line", 0);
  }

  /** How important a line of the log is, as Foxglove counts: 2 is for information, 4 an error. */
  public static int level(String line) {
    String start = line.toLowerCase(Locale.ROOT);
    return start.startsWith("error") ? ERROR : start.startsWith("warning") ? WARNING : INFO;
  }

  private void writeImage(JsonGenerator out, long time, Bytes image) throws IOException {
    writeTime(out, time);
    out.writeStringField("frame_id", path);
    out.writeBinaryField("data", jpeg(image));
    out.writeStringField("format", "jpeg");
  }

  /** The image as a JPEG file; nothing if it is broken. */
  public static byte[] jpeg(Bytes image) {
    try {
      UImage picture = new UBinary(image.keywords(), image.bytes()).uimageValue();
      ImageFormat format = ImageFormat.of(picture.format_string());
      return format == ImageFormat.JPEG
          ? picture.getData()
          : new Picture(format, picture.getWidth(), picture.getHeight(), picture.getData())
              .toJpeg(QUALITY);
    } catch (MediaException | UCastException e) {
      return "".getBytes(StandardCharsets.US_ASCII);
    }
  }
}
