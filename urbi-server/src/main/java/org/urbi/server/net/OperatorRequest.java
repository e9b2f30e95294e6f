package org.urbi.server.net;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.jspecify.annotations.Nullable;

/**
 * What an operator asks of the network thread, since the kernel may be held: {@code interrupt}, and
 * the name of a lobby if it is not for whatever holds the kernel. On the wire it is a telnet
 * subnegotiation of an option that nobody else uses, so that no urbiscript looks like it.
 *
 * @param lobby may be empty
 */
public record OperatorRequest(String lobby) {
  /** The number of the telnet option: the letter U. */
  public static final int OPTION = 'U';

  /** The only request that there is. */
  public static final String INTERRUPT = "interrupt";

  /** The longest request that is listened to, in bytes. */
  static final int MAX_LENGTH = 256;

  /** Stands in the line that answers, before what was done. */
  public static final String ANSWER = ":interrupt] *** ";

  private static final int SE = 240;
  private static final int SB = 250;
  private static final int IAC = 255;

  /** The request as a client sends it. */
  public static byte[] bytes(String lobby) {
    String text =
        ""
            + (char) IAC
            + (char) SB
            + (char) OPTION
            + INTERRUPT
            + " "
            + lobby
            + (char) IAC
            + (char) SE;
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  /** Reads what stands between the beginning and the end of a subnegotiation; null if it is not. */
  static @Nullable OperatorRequest parse(String text) {
    if (text.isEmpty() || text.charAt(0) != OPTION) {
      return null;
    }
    String[] words = text.substring(1).strip().split(" ", 2);
    if (!words[0].toLowerCase(Locale.ROOT).equals(INTERRUPT)) {
      return null;
    }
    return new OperatorRequest(words.length == 1 ? "" : words[1].strip());
  }
}
