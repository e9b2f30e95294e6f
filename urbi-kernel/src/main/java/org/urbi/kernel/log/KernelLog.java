package org.urbi.kernel.log;

import java.util.HexFormat;
import java.util.function.Consumer;

/**
 * The log of a kernel, for its administrator.
 *
 * @param level how much is shown
 * @param lines takes each message, without the end of its line
 */
public record KernelLog(LogLevel level, Consumer<String> lines) {
  /** Before the second line of a message, and those after it: none looks like another message. */
  private static final String CONTINUED = "\n    ";

  private static final int FIRST_WIDE = 0x100;

  /** Whether what has that level is shown. */
  public boolean shows(LogLevel of) {
    return of.compareTo(level) <= 0;
  }

  /**
   * Writes a message. Terminals obey control characters, and there may be texts of anybody in it:
   * such a character is shown as {@code \x1b}.
   */
  public void write(String message) {
    lines.accept(visible(message));
  }

  /** The same text if there is nothing to do: memory may be scarce. */
  private static String visible(String message) {
    for (int i = 0; i < message.length(); i++) {
      if (isControl(message.charAt(i))) {
        return escaped(message);
      }
    }
    return message;
  }

  private static String escaped(String message) {
    StringBuilder text = new StringBuilder(message.length() + CONTINUED.length());
    for (int i = 0; i < message.length(); i++) {
      char c = message.charAt(i);
      if (c == '\n') {
        text.append(CONTINUED);
      } else if (!isControl(c)) {
        text.append(c);
      } else if (c < FIRST_WIDE) {
        text.append("\\x").append(HexFormat.of().toHexDigits((byte) c));
      } else {
        text.append("\\u").append(HexFormat.of().toHexDigits(c));
      }
    }
    return text.toString();
  }

  /** Whether it ends a line, is obeyed by a terminal, or turns round what stands behind it. */
  private static boolean isControl(char c) {
    return switch (Character.getType(c)) {
      case Character.CONTROL -> c != '\t';
      case Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR -> true;
      case Character.FORMAT -> c >= '\u202a' && c <= '\u202e' || c >= '\u2066' && c <= '\u2069';
      default -> false;
    };
  }
}
