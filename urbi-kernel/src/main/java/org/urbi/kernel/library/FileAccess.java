package org.urbi.kernel.library;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.FileSystemLoopException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.lang.print.StringEscape;

/** What File, Directory and the streams have in common: names, errors, waiting for the disk. */
final class FileAccess {
  private FileAccess() {}

  /** The path that an argument names: a String, a Path, a File or a Directory. */
  static UrbiPath path(Frame frame, CallSite site, int place, UrbiObject given) {
    return switch (given) {
      case UrbiPath path -> path;
      case UrbiEntry entry -> entry.path();
      case UrbiString text -> {
        if (text.value().isEmpty() || text.value().indexOf('\0') >= 0) {
          throw frame
              .interpreter()
              .errors()
              .primitive(site.calledName(), "invalid path: " + text.value());
        }
        yield anyPath(frame).sibling(text.value());
      }
      default -> Arguments.unexpected(frame, site, place, given, "Path");
    };
  }

  /** The prototype of paths, from which others can be made. */
  static UrbiPath anyPath(Frame frame) {
    return (UrbiPath) frame.interpreter().world().prototype("Path");
  }

  /** The path of a name in a directory. */
  static UrbiPath inside(UrbiPath directory, String name) {
    String text = directory.text();
    return directory.sibling(text.equals(".") ? name : text + "/" + name);
  }

  /** The last name of a path. */
  static String basename(UrbiPath path) {
    return path.text().substring(path.text().lastIndexOf('/') + 1);
  }

  /** Whether there is something of that name, be it a link to nowhere. */
  static boolean exists(UrbiPath path) {
    return Files.exists(path.file(), LinkOption.NOFOLLOW_LINKS);
  }

  /** {@code routine: message: "path"}. */
  static UrbiException error(Frame frame, CallSite site, String message, UrbiPath path) {
    return frame
        .interpreter()
        .errors()
        .primitive(site.calledName(), message + ": " + StringEscape.quote(path.text()));
  }

  /** Something that can be done to files. */
  interface Action<T> {
    T run() throws IOException;
  }

  /** Does something quick to a file; its failure becomes an exception of urbiscript. */
  static <T> T quickly(Frame frame, CallSite site, UrbiPath path, Action<T> action) {
    try {
      return action.run();
    } catch (IOException e) {
      throw failed(frame, site, path, e);
    }
  }

  /** Does something to files that may take long, while the job waits. */
  static <T> T slowly(Frame frame, CallSite site, UrbiPath path, Callable<T> action) {
    try {
      return KernelControl.of(frame).outside().awaitBriefly(frame.job(), action);
    } catch (IOException e) {
      throw failed(frame, site, path, e);
    }
  }

  private static UrbiException failed(
      Frame frame, CallSite site, UrbiPath path, IOException failure) {
    return error(frame, site, reason(failure), path);
  }

  /** What went wrong, in the words of the manual. */
  static String reason(IOException failure) {
    return switch (failure) {
      case NoSuchFileException e -> "no such file or directory";
      case FileAlreadyExistsException e -> "file exists";
      case DirectoryNotEmptyException e -> "directory not empty";
      case AccessDeniedException e -> "permission denied";
      case NotDirectoryException e -> "not a directory";
      case FileSystemLoopException e -> "too many levels of links";
      case FileSystemException e when e.getReason() != null -> lowered(e.getReason());
      default -> failure.getMessage() == null ? "input/output error" : failure.getMessage();
    };
  }

  /** A message of the machine as part of one of ours. */
  static String lowered(String text) {
    return text.isEmpty()
        ? text
        : text.substring(0, 1).toLowerCase(Locale.ROOT) + text.substring(1);
  }
}
