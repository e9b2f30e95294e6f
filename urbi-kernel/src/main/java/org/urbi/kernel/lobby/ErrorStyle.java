package org.urbi.kernel.lobby;

/** How much the output of a lobby tells about errors. */
public enum ErrorStyle {
  /** The lines of the manual, as programs expect them. */
  PLAIN,

  /** And the lines of the source with the place marked, and a hint. */
  EXPLAINED,

  /** The explained errors, in colours. */
  COLOURED;

  private static final String RESET = "\u001B[0m";

  /** The text of an error or a warning. */
  String problem(String text, boolean error) {
    return paint(error ? "\u001B[1;31m" : "\u001B[1;33m", text);
  }

  /** The mark below the place of the problem. */
  String mark(String text) {
    return paint("\u001B[1;31m", text);
  }

  /** The mark below another place. */
  String note(String text) {
    return paint("\u001B[1;34m", text);
  }

  String hint(String text) {
    return paint("\u001B[36m", text);
  }

  private String paint(String colour, String text) {
    return this == COLOURED ? colour + text + RESET : text;
  }
}
