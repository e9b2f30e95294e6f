package org.urbi.server.cli;

import org.urbi.kernel.lobby.ErrorStyle;

/** Whether the standard streams are a terminal. */
final class Terminal {
  private Terminal() {}

  /**
   * Whether the standard input is a terminal. The launcher tells; Java itself only knows whether
   * both input and output are.
   */
  static boolean isStandardInput() {
    String told = System.getProperty("urbi.stdin.terminal");
    return told == null ? isBoth() : Boolean.parseBoolean(told);
  }

  /** How people who sit there are told of errors. See https://no-color.org for NO_COLOR. */
  static ErrorStyle errorStyle() {
    if (!isBoth()) {
      return ErrorStyle.PLAIN;
    }
    String noColour = System.getenv("NO_COLOR");
    boolean colours =
        (noColour == null || noColour.isEmpty()) && !"dumb".equals(System.getenv("TERM"));
    return colours ? ErrorStyle.COLOURED : ErrorStyle.EXPLAINED;
  }

  /** Whether the standard input and the standard output are a terminal. */
  static boolean isBoth() {
    return System.console() != null && System.console().isTerminal();
  }
}
