package org.urbi.kernel.uobject;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;

/** Text on its way between urbiscript, where a character is a byte, and Java. */
public final class Texts {
  private static final int FIRST_OF_MANY = 128;

  private Texts() {}

  /** The bytes of a text in UTF-8, one in each character. */
  public static String toUrbi(String text) {
    for (int i = 0; i < text.length(); i++) {
      if (text.charAt(i) >= FIRST_OF_MANY) {
        return new String(text.getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1);
      }
    }
    return text;
  }

  /** The text of which these are the bytes in UTF-8; if there is none, the characters as given. */
  public static String toJava(String bytes) {
    for (int i = 0; i < bytes.length(); i++) {
      if (bytes.charAt(i) >= FIRST_OF_MANY) {
        byte[] raw = bytes.getBytes(StandardCharsets.ISO_8859_1);
        try {
          return StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(raw)).toString();
        } catch (CharacterCodingException e) {
          return bytes;
        }
      }
    }
    return bytes;
  }
}
