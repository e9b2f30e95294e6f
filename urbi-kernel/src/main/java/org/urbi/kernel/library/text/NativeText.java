package org.urbi.kernel.library.text;

import java.nio.charset.StandardCharsets;

/**
 * Text on its way to the machine and back: strings of urbiscript are bytes, names of files,
 * variables and programs are UTF-8.
 */
public final class NativeText {
  private NativeText() {}

  /** A string of urbiscript as one of Java. */
  public static String toJava(String bytes) {
    return new String(bytes(bytes), StandardCharsets.UTF_8);
  }

  /** A string of Java as one of urbiscript. */
  public static String toUrbi(String text) {
    return text(text.getBytes(StandardCharsets.UTF_8));
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
