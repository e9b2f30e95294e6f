package org.urbi.server.studio.messages;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.observe.Bytes;

/**
 * Messages of ROS 2, for whatever has a type there: they can be read by programs that know nothing
 * of JSON, and images are a quarter smaller. The fields of variables are called as in JSON.
 */
public enum RosType {
  NUMBER("urbi/msg/Number", "float64 value\n"),
  BOOLEAN("urbi/msg/Boolean", "bool value\n"),
  TEXT("urbi/msg/Text", "string value\n"),
  NUMBERS("urbi/msg/Numbers", "float64[] value\n"),
  IMAGE(
      "sensor_msgs/msg/CompressedImage",
      """
      std_msgs/Header header
      string format
      uint8[] data
      ================================================================================
      MSG: std_msgs/Header
      builtin_interfaces/Time stamp
      string frame_id
      ================================================================================
      MSG: builtin_interfaces/Time
      int32 sec
      uint32 nanosec
      """),
  LOG(
      "rcl_interfaces/msg/Log",
      """
      builtin_interfaces/Time stamp
      uint8 level
      string name
      string msg
      string file
      string function
      uint32 line
      ================================================================================
      MSG: builtin_interfaces/Time
      int32 sec
      uint32 nanosec
      """);

  private static final long SECOND = 1_000_000_000;

  /** A level of Foxglove (2 is for information) times this is one of ROS. */
  private static final int LEVEL = 10;

  private final Form form;

  RosType(String name, String definition) {
    form = Form.ros(name, definition);
  }

  /** How its messages are written. */
  public Form form() {
    return form;
  }

  /** The type of what a topic usually tells; null if ROS has none, as for lists of anything. */
  public static @Nullable RosType of(Topic topic) {
    if (topic.equals(Topic.LOG)) {
      return LOG;
    }
    return switch (topic.kind()) {
      case NUMBER -> NUMBER;
      case BOOLEAN -> BOOLEAN;
      case TEXT -> TEXT;
      case NUMBERS -> NUMBERS;
      case IMAGE -> IMAGE;
      case LIST, DICTIONARY, BINARY, ANY -> null;
    };
  }

  /**
   * A message of this type.
   *
   * @param time in nanoseconds since the Epoch
   * @return null if the value is of another type: a number that is nil by now
   */
  public byte @Nullable [] message(Topic topic, long time, @Nullable Object value) {
    CdrBuffer out = new CdrBuffer();
    return switch (value) {
      case Double number when this == NUMBER -> out.real(number).toBytes();
      case Boolean truth when this == BOOLEAN -> out.octet(truth ? 1 : 0).toBytes();
      case String text when this == TEXT -> out.text(text).toBytes();
      case List<?> list when this == NUMBERS -> numbers(out, list);
      case Bytes image when this == IMAGE ->
          stamp(out, time).text(topic.path()).text("jpeg").block(Topic.jpeg(image)).toBytes();
      case String line when this == LOG ->
          stamp(out, time)
              .octet(LEVEL * Topic.level(line))
              .text("urbi")
              .text(line)
              .text("")
              .text("")
              .number(0)
              .toBytes();
      case null, default -> null;
    };
  }

  private static byte @Nullable [] numbers(CdrBuffer out, List<?> list) {
    List<Double> numbers =
        list.stream().filter(Double.class::isInstance).map(Double.class::cast).toList();
    return numbers.size() == list.size() ? out.reals(numbers).toBytes() : null;
  }

  /** ROS counts seconds with 32 bits: what is later, as simulated time can be, is at their end. */
  private static CdrBuffer stamp(CdrBuffer out, long time) {
    return out.number(Math.clamp(Math.floorDiv(time, SECOND), 0, Integer.MAX_VALUE))
        .number((int) Math.floorMod(time, SECOND));
  }
}
