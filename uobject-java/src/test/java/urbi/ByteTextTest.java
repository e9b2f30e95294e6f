package urbi;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.junit.jupiter.api.Test;
import urbi.wire.ByteText;

class ByteTextTest {
  @Test
  void utf8IsText() {
    for (String text : new String[] {"", "a", "\u00e9", "\uFFFD", "\uD83D\uDE00", "a\0b"}) {
      byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
      assertEquals(text, ByteText.decode(bytes));
      assertArrayEquals(bytes, ByteText.encode(text));
    }
  }

  @Test
  void otherBytesComeBack() {
    assertEquals("a\uDCFFb\u00e9", ByteText.decode(new byte[] {'a', -1, 'b', -61, -87}));
    Random random = new Random(1);
    byte[] parts = {'a', -1, -61, -87, -16, -97, -104, -128, -19, -96, -128, 0};
    for (int i = 0; i < 10_000; i++) {
      byte[] bytes = new byte[random.nextInt(12)];
      for (int j = 0; j < bytes.length; j++) {
        bytes[j] = parts[random.nextInt(parts.length)];
      }
      assertArrayEquals(bytes, ByteText.encode(ByteText.decode(bytes)));
    }
  }
}
