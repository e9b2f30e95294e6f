package org.urbi.ros.frames;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.urbi.ros.Oracle;

/** Where frames are, as tf2 says, and what is said when that is not known. */
class FrameBufferTest {
  private static final long SECOND = 1_000_000_000;

  private final FrameBuffer buffer = new FrameBuffer();

  private static Transform at(double x) {
    return new Transform(x, 0, 0, 0, 0, 0, 1);
  }

  private void put(String parent, String frame, double x, long time) {
    buffer.put(parent, frame, at(x), time, false);
  }

  private String refused(String target, String source, long time) {
    return assertThrows(FrameException.class, () -> buffer.lookup(target, source, time))
        .getMessage();
  }

  private static Transform transform(String[] words, int from) {
    double[] n = new double[7];
    for (int i = 0; i < n.length; i++) {
      n[i] = Double.parseDouble(words[from + i]);
    }
    return new Transform(n[0], n[1], n[2], n[3], n[4], n[5], n[6]);
  }

  /** The same, but for the sign of the quaternion, which does not matter. */
  private static void assertSame(String line, Transform expected, Transform found) {
    double cosine =
        expected.qx() * found.qx()
            + expected.qy() * found.qy()
            + expected.qz() * found.qz()
            + expected.qw() * found.qw();
    assertEquals(1, Math.abs(cosine), 1e-9, line);
    assertEquals(expected.x(), found.x(), 1e-6, line);
    assertEquals(expected.y(), found.y(), 1e-6, line);
    assertEquals(expected.z(), found.z(), 1e-6, line);
  }

  @Test
  void saysWhatTfSays() {
    int found = 0;
    for (String line : Oracle.lines("frames.txt")) {
      String[] words = line.split(" ");
      long time = Long.parseLong(words[3]);
      if (words[0].equals("put")) {
        buffer.put(words[1], words[2], transform(words, 5), time, words[4].equals("1"));
      } else if (words[4].equals("nothing")) {
        assertThrows(FrameException.class, () -> buffer.lookup(words[1], words[2], time), line);
      } else {
        assertSame(line, transform(words, 4), buffer.lookup(words[1], words[2], time).transform());
        found++;
      }
    }
    assertTrue(found > 80, "found: " + found);
  }

  @Test
  void namesWhatIsMissing() {
    assertEquals(
        "nobody has told of a frame 'map' on /tf or /tf_static: there is none yet",
        refused("map", "base", 0));
    put("odom", "base", 1, SECOND);
    put("odom", "base", 2, 2 * SECOND);
    assertEquals(
        "nobody has told of a frame 'map' on /tf or /tf_static: there are [base]",
        refused("map", "base", 0));
    assertEquals(
        "where base was in odom is known from 1.000000 to 2.000000, not at 2.500000"
            + " (0.500000 s too late)",
        refused("odom", "base", 2_500_000_000L));
    assertEquals(
        "where base was in odom is known from 1.000000 to 2.000000, not at 0.250000"
            + " (0.750000 s too early)",
        refused("base", "odom", 250_000_000L));
    put("room", "door", 1, SECOND);
    assertEquals(
        "'base' and 'door' are not connected: the one is within 'odom', the other within 'room'",
        refused("base", "door", 0));
    put("base", "odom", 1, SECOND);
    assertTrue(refused("base", "door", 0).contains("is within itself"));
  }

  @Test
  void timesBetweenAreInterpolated() {
    put("odom", "base", 1, SECOND);
    put("odom", "base", 2, 2 * SECOND);
    assertEquals(1.25, buffer.lookup("odom", "/base", 1_250_000_000L).transform().x());
    assertEquals(-1.25, buffer.lookup("base", "odom", 1_250_000_000L).transform().x());
    assertEquals(2 * SECOND, buffer.lookup("odom", "base", FrameBuffer.NEWEST).time());
    // What is further out need not be known at that time.
    put("map", "odom", 7, SECOND / 2);
    assertEquals(1.5, buffer.lookup("odom", "base", 1_500_000_000L).transform().x());
    // Ten seconds are kept.
    put("odom", "base", 3, 12 * SECOND);
    assertTrue(refused("odom", "base", SECOND).contains("too early"));
    put("odom", "base", 9, SECOND);
    assertTrue(refused("odom", "base", SECOND).contains("too early"));
  }

  @Test
  void whatCannotBeIsRefused() {
    Transform none = new Transform(0, 0, 0, 0, 0, 0, 0);
    assertThrows(FrameException.class, () -> buffer.put("a", "b", none, SECOND, false));
    assertThrows(FrameException.class, () -> buffer.put("a", "b", at(Double.NaN), SECOND, false));
    assertThrows(FrameException.class, () -> buffer.put("a", "a", at(0), SECOND, false));
    assertThrows(FrameException.class, () -> buffer.put("", "a", at(0), SECOND, false));
    for (int i = 0; i < 10_000; i++) {
      put("root", "frame" + i, 0, SECOND);
    }
    assertThrows(FrameException.class, () -> put("root", "another", 0, SECOND));
    buffer.clear();
    buffer.put("root", "fixed", at(0), 0, true);
    put("root", "another", 0, SECOND);
    buffer.clear();
    assertEquals("{fixed=root}", buffer.parents().toString());
  }
}
