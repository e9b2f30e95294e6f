package org.urbi.kernel.journal;

/** A file is no recording that can be replayed; the message says why, of the file. */
public final class RecordingException extends RuntimeException {
  public RecordingException(String message) {
    super(message);
  }
}
