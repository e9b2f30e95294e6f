package org.urbi.kernel.journal;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.FileSystemLoopException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;

/** The serial form of what the machine refuses: a number for the kind, then what it says. */
final class FailureCodec {
  private static final int OTHER = 1;
  private static final int IO = 2;
  private static final int FILE_SYSTEM = 3;
  private static final int NO_SUCH_FILE = 4;
  private static final int EXISTS = 5;
  private static final int NOT_EMPTY = 6;
  private static final int DENIED = 7;
  private static final int NOT_DIRECTORY = 8;
  private static final int LOOP = 9;
  private static final int NOT_FOUND = 10;

  private FailureCodec() {}

  static void write(DataWriter out, Throwable failure) {
    switch (failure) {
      case FileSystemException e -> {
        out.octet(
            switch (e) {
              case NoSuchFileException s -> NO_SUCH_FILE;
              case FileAlreadyExistsException s -> EXISTS;
              case DirectoryNotEmptyException s -> NOT_EMPTY;
              case AccessDeniedException s -> DENIED;
              case NotDirectoryException s -> NOT_DIRECTORY;
              case FileSystemLoopException s -> LOOP;
              default -> FILE_SYSTEM;
            });
        out.any(e.getFile());
        out.any(e.getOtherFile());
        out.any(e.getReason());
      }
      case IOException e -> {
        out.octet(e instanceof FileNotFoundException ? NOT_FOUND : IO);
        out.any(e.getMessage());
      }
      default -> {
        out.octet(OTHER);
        out.any(failure.getMessage() == null ? failure.toString() : failure.getMessage());
      }
    }
  }

  static Throwable read(int kind, DataReader in) {
    String first = (String) in.any();
    switch (kind) {
      case OTHER:
        return new RuntimeException(first);
      case IO:
        return new IOException(first);
      case NOT_FOUND:
        return new FileNotFoundException(first);
      default:
    }
    String other = (String) in.any();
    String reason = (String) in.any();
    return switch (kind) {
      case FILE_SYSTEM -> new FileSystemException(first, other, reason);
      case NO_SUCH_FILE -> new NoSuchFileException(first, other, reason);
      case EXISTS -> new FileAlreadyExistsException(first, other, reason);
      case NOT_EMPTY -> new DirectoryNotEmptyException(first);
      case DENIED -> new AccessDeniedException(first, other, reason);
      case NOT_DIRECTORY -> new NotDirectoryException(first);
      case LOOP -> new FileSystemLoopException(first);
      default -> throw new RecordingException("has a failure of an unknown kind, " + kind);
    };
  }
}
