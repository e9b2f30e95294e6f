package org.urbi.server.studio.messages;

/** A program has sent what makes no sense; the message says what, for people. */
public final class BadMessage extends Exception {
  private static final long serialVersionUID = 1;

  /**
   * @param message what is wrong
   */
  public BadMessage(String message) {
    super(message);
  }
}
