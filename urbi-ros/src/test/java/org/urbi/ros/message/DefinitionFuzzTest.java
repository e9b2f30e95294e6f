package org.urbi.ros.message;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.urbi.ros.Oracle;

/** Texts of types come from others, with each connection of ROS 1: they are read, or refused. */
class DefinitionFuzzTest {
  private static final String LETTERS = "aZ_09 \t\n/[]<=>#\"'\\.,-=:intflo64string";

  @Test
  void brokenTexts() {
    Random dice = new Random(3);
    List<String> types = List.of("nav_msgs/Odometry", "sensor_msgs/Image", "rosgraph_msgs/Log");
    for (String type : types) {
      MessageType message = Oracle.definitions(Dialect.ROS_1).message(type);
      String text = FullText.write(message);
      for (int i = 0; i < 3000; i++) {
        StringBuilder broken = new StringBuilder(text);
        for (int k = dice.nextInt(6); k >= 0; k--) {
          int place = dice.nextInt(broken.length());
          int end = Math.min(broken.length(), place + dice.nextInt(40));
          switch (dice.nextInt(3)) {
            case 0 -> broken.setCharAt(place, LETTERS.charAt(dice.nextInt(LETTERS.length())));
            case 1 -> broken.delete(place, end);
            default -> broken.insert(place, broken.substring(place, end));
          }
        }
        try {
          MessageType read = FullText.read(message.name(), broken.toString());
          TypeHash.md5(read);
          Templates.of(read);
          DefinitionReader.read(message.name(), Dialect.ROS_2, broken.toString());
        } catch (DefinitionException e) {
          // Refused: that is all it may do.
        }
      }
    }
  }
}
