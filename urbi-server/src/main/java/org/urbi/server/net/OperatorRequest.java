package org.urbi.server.net;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.jspecify.annotations.Nullable;

/**
 * A request of an operator to the network thread, which works even while a job holds the kernel:
 * {@code interrupt}, and the name of a lobby unless it means whatever holds the kernel. It is sent
 * as a telnet subnegotiation of an otherwise unused option, so no urbiscript looks like it.
 *
 * @param lobby may be empty
 */
public record OperatorRequest(String lobby) {
  /** The number of the telnet option: the letter U. */
  public static final int OPTION = 'U';

  /** The only kind of request. */
  public static final String INTERRUPT = "interrupt";

  /** The maximum length of a request, in bytes. */
  static final int MAX_LENGTH = 256;

  /** The beginning of the answer, before the result. */
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

  /** Parses the content of a subnegotiation; null if it is not a request. */
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
