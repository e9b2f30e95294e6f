package org.urbi.server.studio.access;

/** Somebody is not let in; the message tells him why. */
public final class Refused extends Exception {
  private static final long serialVersionUID = 1;

  Refused(String message) {
    super(message);
  }
}
