package org.urbi.server.cli;

/** Whether somebody is sitting there. */
final class Terminal {
  private Terminal() {}

  /** Whether the standard input is a terminal; the launcher knows, Java only knows of both ends. */
  static boolean isStandardInput() {
    String told = System.getProperty("urbi.stdin.terminal");
    return told == null ? isBoth() : Boolean.parseBoolean(told);
  }

  /** Whether the standard input and the standard output are a terminal. */
  static boolean isBoth() {
    return System.console() != null && System.console().isTerminal();
  }
}
