package org.urbi.kernel.library.text;

import java.util.function.IntPredicate;
import java.util.function.IntUnaryOperator;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.object.Utf8Text;

/** Character classes of the bytes of strings; bytes that are not ASCII belong to none. */
public final class Characters {
  private Characters() {}

  /** Whether all characters of a text, which may be long, have a property. */
  static boolean all(Job job, String text, IntPredicate property) {
    for (int i = 0; i < text.length(); i++) {
      job.worked(1);
      if (!property.test(text.charAt(i))) {
        return false;
      }
    }
    return true;
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

  /** The text, which may be long, with its letters in upper case. */
  static String upper(Job job, String text) {
    return mapped(job, text, c -> isLower(c) ? c - 'a' + 'A' : c);
  }

  /** The text, which may be long, with its letters in lower case. */
  static String lower(Job job, String text) {
    return mapped(job, text, c -> isUpper(c) ? c - 'A' + 'a' : c);
  }

  private static String mapped(Job job, String text, IntUnaryOperator mapping) {
    byte[] bytes = Utf8Text.bytes(text);
    for (int i = 0; i < bytes.length; i++) {
      job.worked(1);
      bytes[i] = (byte) mapping.applyAsInt(bytes[i]);
    }
    return Utf8Text.text(bytes);
  }
}
