package org.urbi.server.studio;

/** A browser has sent what makes no sense; the message says what, for people. */
final class BadRequest extends Exception {
  private static final long serialVersionUID = 1;

  BadRequest(String message) {
    super(message);
  }
}
