package org.urbi.ros.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import urbi.UBinary;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

class FieldPathTest {
  private static final Definitions TYPES =
      new Definitions(Dialect.ROS_1, new InterfaceFiles(List.of()));

  private static UDictionary message(String type) {
    return Templates.of(TYPES.message(type));
  }

  @Test
  void valuesAreReadAndSet() {
    UDictionary twist = message("geometry_msgs/Twist");
    FieldPath path = FieldPath.of("linear.x");
    path.check(TYPES.message("geometry_msgs/Twist"));
    path.put(twist, new UValue(3.0));
    assertEquals(3, path.get(twist).doubleValue());
    assertEquals(0, FieldPath.of("linear.y").get(twist).doubleValue());
    UDictionary pose = message("geometry_msgs/PoseWithCovariance");
    FieldPath.of("covariance[35]").put(pose, new UValue(7.0));
    assertEquals(7, FieldPath.of("covariance[35]").get(pose).doubleValue());
    UDictionary image = message("sensor_msgs/Image");
    image.put("data", new UValue(new UBinary(new byte[] {1, -1})));
    assertEquals(255, FieldPath.of("data[1]").get(image).doubleValue());
    FieldPath.of("header.stamp.sec").check(TYPES.message("sensor_msgs/Image"));
    FieldPath.of("").put(twist, new UValue(message("geometry_msgs/Twist")));
    assertEquals(0, path.get(twist).doubleValue());
  }

  @Test
  void whatIsNotThereIsNamed() {
    assertThrows(
        ValueException.class,
        () -> FieldPath.of("linear.w").check(TYPES.message("geometry_msgs/Twist")));
    assertThrows(
        ValueException.class,
        () -> FieldPath.of("linear[0]").check(TYPES.message("geometry_msgs/Twist")));
    assertThrows(
        ValueException.class,
        () ->
            FieldPath.of("covariance[36]")
                .check(TYPES.message("geometry_msgs/PoseWithCovariance")));
    UDictionary scan = message("sensor_msgs/LaserScan");
    FieldPath third = FieldPath.of("ranges[3]");
    third.check(TYPES.message("sensor_msgs/LaserScan"));
    assertThrows(ValueException.class, () -> third.get(scan));
    scan.put("ranges", new UValue(UList.of(1, 2, 3, 4)));
    assertEquals(4, third.get(scan).doubleValue());
    assertThrows(ValueException.class, () -> FieldPath.of("").put(scan, new UValue(1.0)));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {".", ".x", "x.", "x..y", "x[", "x[1", "x[-1]", "x[1234567890]", "x y", "[]", "3"})
  void whatIsNoPathIsRefused(String text) {
    assertThrows(ValueException.class, () -> FieldPath.of(text));
  }
}
