package org.urbi.kernel.library.text;

import java.util.function.IntPredicate;

/** Character classes of the bytes of strings; bytes that are not ASCII belong to none. */
public final class Characters {
  private Characters() {}

  static boolean all(String text, IntPredicate property) {
    return text.chars().allMatch(property);
  }

  static boolean isControl(int c) {
    return c < 0x20 || c == 0x7F;
  }

  static boolean isSpace(int c) {
    return c == ' ' || c >= 0x09 && c <= 0x0D;
  }

  static boolean isUpper(int c) {
    return c >= 'A' && c <= 'Z';
  }

  static boolean isLower(int c) {
    return c >= 'a' && c <= 'z';
  }

  static boolean isLetter(int c) {
    return isUpper(c) || isLower(c);
  }

  static boolean isDigit(int c) {
    return c >= '0' && c <= '9';
  }

  static boolean isHexadecimal(int c) {
    return isDigit(c) || c >= 'A' && c <= 'F' || c >= 'a' && c <= 'f';
  }

  static boolean isLetterOrDigit(int c) {
    return isLetter(c) || isDigit(c);
  }

  static boolean isVisible(int c) {
    return c > ' ' && c < 0x7F;
  }

  static boolean isPunctuation(int c) {
    return isVisible(c) && !isLetterOrDigit(c);
  }

  /** The text with its letters in upper case. */
  static String upper(String text) {
    char[] chars = text.toCharArray();
    for (int i = 0; i < chars.length; i++) {
      chars[i] = isLower(chars[i]) ? (char) (chars[i] - 'a' + 'A') : chars[i];
    }
    return new String(chars);
  }

  /** The text with its letters in lower case. */
  public static String lower(String text) {
    char[] chars = text.toCharArray();
    for (int i = 0; i < chars.length; i++) {
      chars[i] = isUpper(chars[i]) ? (char) (chars[i] - 'A' + 'a') : chars[i];
    }
    return new String(chars);
  }
}
