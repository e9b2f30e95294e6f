package org.urbi.server.console;

/** Shows the output of a lobby. */
public interface ConsoleOutput extends AutoCloseable {
  /** Shows a text in which each character is a byte. */
  void add(String bytes);

  /** Waits until everything has been shown. */
  @Override
  void close();
}
