package urbi.wire;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;

/**
 * Text in Java for any sequence of bytes, such as a string of urbiscript or of C++: UTF-8, and for
 * each byte that is no part of UTF-8 a lone surrogate, U+DC80 to U+DCFF. Nothing is lost: what is
 * decoded is encoded as it was.
 */
public final class ByteText {
  private static final int FIRST_LONE = 0xDC00;
  private static final int FIRST_NOT_ASCII = 0x80;
  private static final int PAST_BYTES = 0x100;

  private ByteText() {}

  /** The text of bytes. */
  public static String decode(byte[] bytes) {
    return decode(bytes, 0, bytes.length);
  }

  /** The text of some bytes. */
  public static String decode(byte[] bytes, int from, int length) {
    String text = new String(bytes, from, length, StandardCharsets.UTF_8);
    // Where a byte is invalid, or where the text has that character.
    return text.indexOf('\uFFFD') < 0 ? text : decodeAny(bytes, from, length);
  }

  private static String decodeAny(byte[] bytes, int from, int length) {
    ByteBuffer in = ByteBuffer.wrap(bytes, from, length);
    CharBuffer out = CharBuffer.allocate(length);
    CharsetDecoder decoder = StandardCharsets.UTF_8.newDecoder();
    CoderResult result = decoder.decode(in, out, true);
    while (result.isError()) {
      for (int i = 0; i < result.length(); i++) {
        out.put((char) (FIRST_LONE + (in.get() & 0xFF)));
      }
      result = decoder.reset().decode(in, out, true);
    }
    return out.flip().toString();
  }

  /** The bytes of a text. */
  public static byte[] encode(String text) {
    for (int i = 0; i < text.length(); i++) {
      if (isByte(text, i)) {
        return encodeAny(text);
      }
    }
    return text.getBytes(StandardCharsets.UTF_8);
  }

  /** Whether a character stands for a byte. */
  private static boolean isByte(String text, int index) {
    char c = text.charAt(index);
    return c >= FIRST_LONE + FIRST_NOT_ASCII
        && c < FIRST_LONE + PAST_BYTES
        && (index == 0 || !Character.isHighSurrogate(text.charAt(index - 1)));
  }

  private static byte[] encodeAny(String text) {
    ByteBuffer out = ByteBuffer.allocate(3 * text.length());
    int begun = 0;
    for (int i = 0; i < text.length(); i++) {
      if (isByte(text, i)) {
        out.put(text.substring(begun, i).getBytes(StandardCharsets.UTF_8));
        out.put((byte) (text.charAt(i) - FIRST_LONE));
        begun = i + 1;
      }
    }
    out.put(text.substring(begun).getBytes(StandardCharsets.UTF_8));
    byte[] bytes = new byte[out.position()];
    out.flip().get(bytes);
    return bytes;
  }
}
