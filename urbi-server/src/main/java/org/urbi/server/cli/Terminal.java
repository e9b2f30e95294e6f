package org.urbi.server.cli;

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

  /** Whether the standard input and the standard output are a terminal. */
  static boolean isBoth() {
    return System.console() != null && System.console().isTerminal();
  }
}
