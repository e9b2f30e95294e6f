package org.urbi.ros.two;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.urbi.ros.rtps.Guid;

/** Lists of nodes, good and bad. */
class EntitiesTest {
  private static Guid guid(int number) {
    byte[] bytes = new byte[16];
    bytes[15] = (byte) number;
    return Guid.of(bytes);
  }

  private static final Entities SOME =
      new Entities(
          guid(1),
          List.of(
              new Entities.NodeEntities("/", "a", List.of(guid(2)), List.of()),
              new Entities.NodeEntities("/far", "away", List.of(), List.of(guid(3), guid(4)))));

  @Test
  void areReadAsTheyWereWritten() {
    assertEquals(SOME, Entities.decode(SOME.encode()));
    assertEquals("/a", SOME.nodes().get(0).fullName());
    assertEquals("/far/away", SOME.nodes().get(1).fullName());
  }

  @Test
  void whateverChangesOnlyTheirOwnExceptionComes() {
    Random random = new Random(1);
    byte[] valid = new byte[SOME.encode().remaining()];
    SOME.encode().get(valid);
    int refused = 0;
    for (int i = 0; i < 100_000; i++) {
      byte[] bytes = java.util.Arrays.copyOf(valid, random.nextInt(valid.length + 1));
      for (int j = 0; j < 3 && bytes.length > 0; j++)
        bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
      try {
        Entities.decode(ByteBuffer.wrap(bytes));
      } catch (IllegalArgumentException e) {
        refused++;
      }
    }
    assertTrue(refused > 50_000, "refused: " + refused);
  }

  @Test
  void namesAreMangledAndBack() {
    assertEquals("rt/a/b", Mangling.topic("/a/b"));
    assertEquals("/a/b", Mangling.topicOf("rt/a/b"));
    assertEquals("", Mangling.topicOf("rq/a/bRequest"));
    assertEquals("/a/b", Mangling.serviceOf("rq/a/bRequest"));
    assertEquals("", Mangling.serviceOf("rr/a/bReply"));
    assertEquals("std_msgs/msg/String", Mangling.typeOf("std_msgs::msg::dds_::String_"));
    assertEquals("a/srv/B", Mangling.serviceTypeOf("a::srv::dds_::B_Request_"));
    assertEquals("Plain", Mangling.typeOf("Plain"));
  }
}
