package org.urbi.ros.codec;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.urbi.ros.Oracle;
import org.urbi.ros.message.Definitions;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.Templates;
import org.urbi.ros.message.ValueException;
import urbi.UBinary;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/** Messages are the bytes that ROS itself makes of them. */
class MessageCodecTest {
  private static MessageCodec codec(Dialect dialect, String type) {
    return MessageCodec.of(Oracle.definitions(dialect).message(type));
  }

  /** With lists of numbers for Binaries, as the oracles write them. */
  private static UValue plain(UValue value) {
    return switch (value.getType()) {
      case DATA_BINARY -> {
        UList bytes = new UList();
        for (byte each : value.ubinaryValue().getData()) {
          bytes.add(new UValue((double) (each & 0xFF)));
        }
        yield new UValue(bytes);
      }
      case DATA_LIST -> {
        UList list = new UList();
        value.ulistValue().forEach(each -> list.add(plain(each)));
        yield new UValue(list);
      }
      case DATA_DICTIONARY -> new UValue(plain(value.udictionaryValue()));
      default -> value;
    };
  }

  private static UDictionary plain(UDictionary message) {
    UDictionary copy = new UDictionary();
    for (Map.Entry<String, UValue> each : message.entrySet()) {
      copy.put(each.getKey(), plain(each.getValue()));
    }
    return copy;
  }

  @Test
  void asRosOneDoesIt() {
    Definitions definitions = Oracle.definitions(Dialect.ROS_1);
    for (String line : Oracle.lines("ros1.txt")) {
      String[] columns = line.split("\t");
      MessageCodec codec = MessageCodec.of(definitions.message(columns[0]));
      byte[] bytes = HexFormat.of().parseHex(columns[1]);
      UDictionary value = UValue.parse(columns[2]).udictionaryValue();
      assertEquals(value, plain(codec.decode(bytes)), columns[0]);
      assertArrayEquals(bytes, codec.encode(value), columns[0]);
      assertArrayEquals(bytes, codec.encode(codec.decode(bytes)), columns[0]);
    }
  }

  @Test
  void asRosTwoDoesIt() {
    Definitions definitions = Oracle.definitions(Dialect.ROS_2);
    for (String line : Oracle.lines("ros2.txt")) {
      String[] columns = line.split("\t");
      MessageCodec codec = MessageCodec.of(definitions.message(columns[0]));
      byte[] bytes = HexFormat.of().parseHex(columns[1]);
      UDictionary value = UValue.parse(columns[2]).udictionaryValue();
      assertEquals(value, plain(codec.decode(bytes)), columns[0]);
      byte[] ours = codec.encode(value);
      // Whatever is filled in between is not zero there; at the end, some room may be left.
      assertTrue(ours.length <= bytes.length, columns[0]);
      assertEquals(value, plain(codec.decode(ours)), columns[0]);
      assertEquals(
          value, plain(codec.decode(codec.encode(value, ByteOrder.BIG_ENDIAN))), columns[0]);
    }
  }

  @Test
  void templatesAreWhatTheOraclesBeginWith() {
    for (Dialect dialect : Dialect.values()) {
      Definitions definitions = Oracle.definitions(dialect);
      String before = "";
      for (String line : Oracle.lines("ros" + dialect.version() + ".txt")) {
        String[] columns = line.split("\t");
        if (!columns[0].equals(before)) {
          before = columns[0];
          UDictionary template = Templates.of(definitions.message(columns[0]));
          MessageCodec codec = MessageCodec.of(definitions.message(columns[0]));
          assertEquals(
              UValue.parse(columns[2]).udictionaryValue(),
              plain(codec.decode(codec.encode(template))),
              columns[0]);
        }
      }
    }
  }

  @Test
  void bigEndian() {
    MessageCodec codec = codec(Dialect.ROS_2, "std_msgs/Int32");
    byte[] bytes = {0, 0, 0, 0, 0, 0, 1, 2};
    assertEquals(258, codec.decode(bytes).get("data").intValue());
    assertArrayEquals(
        bytes, codec.encode(new UDictionary().with("data", 258), ByteOrder.BIG_ENDIAN));
  }

  @Test
  void theLargestNumbersComeBack() {
    MessageCodec codec = codec(Dialect.ROS_1, "std_msgs/UInt64");
    byte[] most = HexFormat.of().parseHex("ffffffffffffffff");
    assertArrayEquals(most, codec.encode(codec.decode(most)));
    byte[] half = HexFormat.of().parseHex("0000000000000080");
    assertArrayEquals(half, codec.encode(codec.decode(half)));
  }

  private static String problem(MessageCodec codec, String message) {
    return assertThrows(
            ValueException.class, () -> codec.encode(UValue.parse(message).udictionaryValue()))
        .getMessage();
  }

  @Test
  void whatIsWrongNamesTheField() {
    MessageCodec point = codec(Dialect.ROS_1, "geometry_msgs/PointStamped");
    String header =
        "[\"header\" => [\"seq\" => 1, \"stamp\" => [\"sec\" => %s, \"nanosec\" => 0],"
            + " \"frame_id\" => %s], \"point\" => [\"x\" => 0, \"y\" => 0%s]]";
    assertEquals(
        "header.stamp.sec: a number expected, not \"x\"",
        problem(point, header.formatted("\"x\"", "\"\"", "")));
    assertEquals(
        "header.stamp.sec: -1 is out of range of uint32",
        problem(point, header.formatted("-1", "\"\"", "")));
    assertEquals(
        "header.frame_id: a string expected, not 5",
        problem(point, header.formatted("1", "5", "")));
    assertEquals(
        "point.z: this key of geometry_msgs/Point is missing",
        problem(point, header.formatted("1", "\"\"", "")));
    assertEquals(
        "point.w: geometry_msgs/Point has no such key; it has [x, y, z]",
        problem(point, header.formatted("1", "\"\"", ", \"z\" => 1, \"w\" => 1")));
    MessageCodec array = codec(Dialect.ROS_1, "std_msgs/Int8MultiArray");
    assertEquals(
        "layout.dim[1]: a Dictionary (std_msgs/MultiArrayDimension) expected, not 7",
        problem(
            array,
            "[\"layout\" => [\"dim\" => [[\"label\" => \"\", \"size\" => 1, \"stride\" => 1], 7],"
                + " \"data_offset\" => 0], \"data\" => []]"));
    assertEquals(
        "data[2]: 128 is out of range of int8",
        problem(
            array,
            "[\"layout\" => [\"dim\" => [], \"data_offset\" => 0], \"data\" => [1, 2, 128]]"));
    assertEquals(
        "data: a whole number expected, not 1.5",
        problem(codec(Dialect.ROS_1, "std_msgs/Int32"), "[\"data\" => 1.5]"));
    assertEquals(
        "data: 1e300 is out of range of float32",
        problem(codec(Dialect.ROS_2, "std_msgs/Float32"), "[\"data\" => 1e300]"));
    assertEquals(
        "uuid: 16 elements expected, not 2",
        problem(codec(Dialect.ROS_2, "unique_identifier_msgs/UUID"), "[\"uuid\" => [1, 2]]"));
  }

  @Test
  void bytesAreCopiedOnceAndNotMore() {
    MessageCodec codec = codec(Dialect.ROS_1, "sensor_msgs/Image");
    UDictionary image = Templates.of(codec.type());
    image.put("data", new UValue(new UBinary(new byte[640 * 480 * 3])));
    byte[] bytes = codec.encode(image);
    for (int i = 0; i < 3; i++) {
      codec.decode(bytes);
    }
    var threads =
        (com.sun.management.ThreadMXBean) java.lang.management.ManagementFactory.getThreadMXBean();
    long before = threads.getCurrentThreadAllocatedBytes();
    codec.decode(bytes);
    long allocated = threads.getCurrentThreadAllocatedBytes() - before;
    assertTrue(allocated < 640 * 480 * 3 + 20_000, allocated + " bytes");
  }

  @Test
  void whatIsNoMessageIsRefused() {
    MessageCodec text = codec(Dialect.ROS_2, "std_msgs/String");
    assertThrows(CodecException.class, () -> text.decode(new byte[] {0, 1}));
    assertThrows(CodecException.class, () -> text.decode(new byte[] {0, 7, 0, 0, 0, 0, 0, 0}));
    byte[] full =
        codec(Dialect.ROS_1, "std_msgs/String").encode(new UDictionary().with("data", "abc"));
    assertThrows(
        CodecException.class,
        () -> codec(Dialect.ROS_1, "std_msgs/String").decode(Arrays.copyOf(full, full.length + 1)));
  }
}
