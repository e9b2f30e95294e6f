package org.urbi.server.console;

/** Where a lobby's output is shown. */
public interface ConsoleOutput extends AutoCloseable {
  /** Shows bytes, one for each character. */
  void add(String bytes);

  /** Waits until everything has been shown. */
  @Override
  void close();
}
