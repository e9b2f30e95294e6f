package org.urbi.kernel.object;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import urbi.wire.ByteText;

/**
 * Converts text between urbiscript and Java. A string of urbiscript is a sequence of bytes, one in
 * each character; text in it is encoded in UTF-8.
 */
public final class Utf8Text {
  private static final int FIRST_NOT_ASCII = 128;

  private Utf8Text() {}

  /** Encodes a Java text for urbiscript: its bytes in UTF-8, one in each character. */
  public static String toUrbi(String text) {
    return isAscii(text) ? text : text(text.getBytes(StandardCharsets.UTF_8));
  }

  /** Decodes a string of urbiscript; where it is not UTF-8, it is returned as it is. */
  public static String toJava(String bytes) {
    if (isAscii(bytes)) {
      return bytes;
    }
    try {
      return StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes(bytes))).toString();
    } catch (CharacterCodingException e) {
      return bytes;
    }
  }

  /** Decodes a string for a component, which can give it back as it was: see {@link ByteText}. */
  public static String toComponent(String bytes) {
    return isAscii(bytes) ? bytes : ByteText.decode(bytes(bytes));
  }

  /** Encodes a text of a component. */
  public static String fromComponent(String text) {
    return isAscii(text) ? text : text(ByteText.encode(text));
  }

  private static boolean isAscii(String text) {
    for (int i = 0; i < text.length(); i++) {
      if (text.charAt(i) >= FIRST_NOT_ASCII) {
        return false;
      }
    }
    return true;
  }

  /** The bytes of a string of urbiscript. */
  public static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  /** Bytes as a string of urbiscript. */
  public static String text(byte[] bytes) {
    return new String(bytes, StandardCharsets.ISO_8859_1);
  }
}
