package org.urbi.server.studio;

import org.jspecify.annotations.Nullable;

/** A browser has sent what makes no sense; the message says what, for people. */
final class BadRequest extends Exception {
  private static final long serialVersionUID = 1;

  private final @Nullable Long id;

  BadRequest(String message) {
    this(message, null);
  }

  /**
   * @param id by which the browser knows the answer that it waits for; null if it waits for none
   */
  BadRequest(String message, @Nullable Long id) {
    super(message);
    this.id = id;
  }

  /** What the browser is told. */
  String answer() {
    String reason = String.valueOf(getMessage());
    return id == null ? Answer.text("error", reason) : Answer.done(id, reason);
  }
}
