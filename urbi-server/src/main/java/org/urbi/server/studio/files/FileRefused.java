package org.urbi.server.studio.files;

/** Something cannot be done with a file; the message tells people why. */
public final class FileRefused extends Exception {
  private static final long serialVersionUID = 1;

  FileRefused(String message) {
    super(message);
  }
}
