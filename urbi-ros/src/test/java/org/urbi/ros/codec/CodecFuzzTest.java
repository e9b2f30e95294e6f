package org.urbi.ros.codec;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.urbi.ros.Oracle;
import org.urbi.ros.message.Definitions;
import org.urbi.ros.message.Dialect;

/** Whatever comes, a decoder reads a message or refuses it, and takes no memory to speak of. */
class CodecFuzzTest {
  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  /** Per byte of a message: a number of one byte becomes an object of urbiscript. */
  private static final int MOST = 200;

  private static void decode(MessageCodec codec, byte[] bytes) {
    long before = THREADS.getCurrentThreadAllocatedBytes();
    try {
      codec.decode(bytes);
    } catch (CodecException e) {
      // Refused: that is all it may do.
    }
    long taken = THREADS.getCurrentThreadAllocatedBytes() - before;
    assertTrue(
        taken < 400_000 + (long) MOST * bytes.length,
        () -> codec.type().name() + " takes " + taken + ": " + HexFormat.of().formatHex(bytes));
  }

  @Test
  void brokenMessages() {
    Random dice = new Random(7);
    for (Dialect dialect : Dialect.values()) {
      Definitions definitions = Oracle.definitions(dialect);
      for (String line : Oracle.lines("ros" + dialect.version() + ".txt")) {
        String[] columns = line.split("\t");
        MessageCodec codec = MessageCodec.of(definitions.message(columns[0]));
        byte[] bytes = HexFormat.of().parseHex(columns[1]);
        for (int i = 0; i < 200; i++) {
          byte[] broken = Arrays.copyOf(bytes, dice.nextInt(bytes.length + 5));
          for (int k = dice.nextInt(4); k > 0 && broken.length > 0; k--) {
            int place = dice.nextInt(broken.length);
            // Lengths are at the end of four bytes: there a large one is made best.
            broken[place] = (byte) (dice.nextBoolean() ? 0xFF : dice.nextInt());
          }
          decode(codec, broken);
        }
        for (int i = 0; i < 50; i++) {
          byte[] random = new byte[dice.nextInt(100)];
          dice.nextBytes(random);
          decode(codec, random);
        }
      }
    }
  }
}
