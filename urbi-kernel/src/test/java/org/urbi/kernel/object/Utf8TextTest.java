package org.urbi.kernel.object;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Text outside is Java's; inside each character is a byte of UTF-8. */
class Utf8TextTest {
  @ParameterizedTest
  @CsvSource({
    "'',''",
    "plain ~\u007f,plain ~\u007f",
    "\u00e9,\u00c3\u00a9",
    "a\u20acb,a\u00e2\u0082\u00acb"
  })
  void textIsEncodedAndDecoded(String java, String urbi) {
    assertEquals(urbi, Utf8Text.toUrbi(java));
    assertEquals(java, Utf8Text.toJava(urbi));
    assertEquals(java, Utf8Text.toComponent(urbi));
    assertEquals(urbi, Utf8Text.fromComponent(java));
  }

  /** 0x80 is the first byte that is no character by itself. */
  @ParameterizedTest
  @CsvSource({"\u0080", "\u00ff\u00fe", "a\u00c3"})
  void whatIsNoTextStaysAsItIs(String bytes) {
    assertEquals(bytes, Utf8Text.toJava(bytes));
    String given = Utf8Text.toComponent(bytes);
    assertNotEquals(bytes, given);
    assertEquals(bytes, Utf8Text.fromComponent(given), "a component gives back what it was given");
  }

  @Test
  void bytesAreCharacters() {
    byte[] all = new byte[256];
    for (int i = 0; i < all.length; i++) {
      all[i] = (byte) i;
    }
    String text = Utf8Text.text(all);
    assertEquals(256, text.length());
    assertEquals('\u00ff', text.charAt(255));
    assertArrayEquals(all, Utf8Text.bytes(text));
  }
}
