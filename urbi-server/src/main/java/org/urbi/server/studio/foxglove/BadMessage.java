package org.urbi.server.studio.foxglove;

/** A program has sent what makes no sense; the message says what, for people. */
final class BadMessage extends Exception {
  private static final long serialVersionUID = 1;

  BadMessage(String message) {
    super(message);
  }
}
