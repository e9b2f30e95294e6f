package org.urbi.kernel.library.file;

import static java.util.Objects.requireNonNull;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.FileSystemLoopException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.library.date.UrbiDate;
import org.urbi.kernel.library.value.Counting;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.outside.Disk;
import org.urbi.kernel.outside.Outside;
import org.urbi.lang.print.StringEscape;

/** The common part of File, Directory and the streams: names, errors, waiting for the disk. */
public final class FileAccess {
  /** Larger files, and all that are no regular files, are read on a thread of their own. */
  static final long LARGE = 1 << 18;

  private static final int LONGEST_NAME = 1 << 16;

  private final Outside outside;

  public FileAccess(Outside outside) {
    this.outside = outside;
  }

  /** The path that an argument names: a String, a Path, a File or a Directory. */
  public static UrbiPath path(Frame frame, CallSite site, int place, UrbiObject given) {
    return switch (given) {
      case UrbiPath path when path != anyPath(frame) -> path;
      case FileSystemEntry entry when entry.path() != null -> entry.path();
      case UrbiString text -> {
        checkName(frame, site, text.value());
        yield anyPath(frame).sibling(text.value());
      }
      case UrbiPath prototype -> throw frame.error(site, Problem.NOT_A_PATH);
      default -> Arguments.unexpected(frame, site, place, given, "Path");
    };
  }

  /** {@code routine: invalid path: …} unless it may be the name of something. */
  static void checkName(Frame frame, CallSite site, String name) {
    if (name.isEmpty() || name.indexOf('\0') >= 0) {
      throw frame.error(site, Problem.INVALID_PATH, name);
    }
    checkLength(frame, site, name);
  }

  /** Nothing has a longer name; and whoever takes it apart need not ask whether to continue. */
  static void checkLength(Frame frame, CallSite site, String name) {
    if (name.length() > LONGEST_NAME) {
      throw frame.error(site, Problem.PATH_TOO_LONG, name.length());
    }
  }

  /** The prototype of paths, from which others can be made. */
  public static UrbiPath anyPath(Frame frame) {
    return (UrbiPath) frame.interpreter().world().prototype("Path");
  }

  /**
   * Refuses to connect the shared prototype with a file: only objects created by {@code new} can
   * be.
   */
  public static void checkNotPrototype(Frame frame, CallSite site, UrbiObject self, String type) {
    if (self == frame.interpreter().world().prototype(type)) {
      throw frame.error(site, Problem.IS_A_PROTOTYPE, type, type);
    }
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

  /** The files that this kernel may use. */
  public Disk disk() {
    return outside.disk();
  }

  /** Whether there is something of that name; a link to nowhere is nothing. */
  boolean exists(Frame frame, CallSite site, UrbiPath path) {
    return quickly(frame, site, path, () -> disk().exists(path.file()));
  }

  /** Whether a file of that name exists; a dangling link counts. */
  boolean hasEntry(Frame frame, CallSite site, UrbiPath path) {
    return quickly(frame, site, path, () -> disk().hasEntry(path.file()));
  }

  /** Whether there is a directory of that name. */
  boolean isDirectory(Frame frame, CallSite site, UrbiPath path) {
    return quickly(frame, site, path, () -> disk().isDirectory(path.file()));
  }

  /** Whether there is a regular file of that name. */
  boolean isRegularFile(Frame frame, CallSite site, UrbiPath path) {
    return quickly(frame, site, path, () -> disk().isRegularFile(path.file()));
  }

  /** The path of a directory that must exist. */
  UrbiPath existingDirectory(Frame frame, CallSite site, int place, UrbiObject name) {
    UrbiPath path = path(frame, site, place, name);
    if (!isDirectory(frame, site, path)) {
      throw error(
          frame,
          site,
          exists(frame, site, path) ? Problem.NOT_A_DIRECTORY : Problem.DIRECTORY_MISSING,
          path);
    }
    return path;
  }

  /** The date at which something was last modified. */
  UrbiObject lastModified(Frame frame, CallSite site, UrbiPath path) {
    long microseconds = quickly(frame, site, path, () -> disk().lastModified(path.file()));
    UrbiObject prototype = frame.interpreter().world().prototype("Date");
    return new UrbiDate(prototype.cloneShape(), microseconds);
  }

  /** {@code routine: message: "path"}. */
  static UrbiException error(Frame frame, CallSite site, Problem reason, UrbiPath path) {
    return error(frame, site, reason.text(), path);
  }

  private static UrbiException error(Frame frame, CallSite site, String reason, UrbiPath path) {
    return frame.error(site, Problem.AT_PATH, reason, StringEscape.quote(path.text()));
  }

  /** Something that can be done to files. */
  public interface Action<T> {
    T run() throws IOException;
  }

  /** Does something quick to a file; its failure becomes an exception of urbiscript. */
  public static <T> T quickly(Frame frame, CallSite site, UrbiPath path, Action<T> action) {
    try {
      return action.run();
    } catch (IOException e) {
      throw failed(frame, site, path, e);
    }
  }

  /**
   * All bytes of a file, as far as the budget of the job allows so many; if it is large, the job
   * waits for them.
   *
   * @param path how messages call it
   */
  public byte[] content(Frame frame, CallSite site, UrbiPath path, Path file) {
    Disk disk = disk();
    long most = frame.job().budget().limit(Resource.MEMORY);
    try {
      if (disk.isRegularFile(file)) {
        long size = disk.size(file);
        Counting.checkMemory(frame, size);
        // Those of the operating system (proc(5)) seem to be empty, and may make readers wait.
        if (size > 0 && size <= LARGE) {
          return disk.read(file, most);
        }
      }
    } catch (IOException e) {
      // The other way says what is wrong.
    }
    return slowly(
        frame,
        site,
        path,
        file,
        () -> {
          if (disk.isRegularFile(file) && disk.size(file) > Integer.MAX_VALUE - 8) {
            throw new IOException(Problem.FILE_TOO_LARGE.text());
          }
          return disk.read(file, most);
        });
  }

  /** Finds out about files what may take long, while the job waits. */
  <T> T slowly(Frame frame, CallSite site, UrbiPath path, Callable<T> action) {
    return slowly(frame, site, path, path.file(), action);
  }

  private <T> T slowly(Frame frame, CallSite site, UrbiPath path, Path file, Callable<T> action) {
    try {
      return requireNonNull(
          outside.awaitBriefly(frame.job(), file, action), "what is found out is there");
    } catch (IOException e) {
      throw failed(frame, site, path, e);
    }
  }

  /** Opens a file, which may take long, while the job waits; null in a replay. */
  <T> @Nullable T openSlowly(Frame frame, CallSite site, UrbiPath path, Callable<T> action) {
    try {
      return outside.openBriefly(frame.job(), path.file(), action);
    } catch (IOException e) {
      throw failed(frame, site, path, e);
    }
  }

  /** Something is to be moved or copied there: there must be a directory for it. */
  void checkPlace(Frame frame, CallSite site, UrbiPath to) {
    if (!isDirectory(frame, site, PathType.dirname(to))) {
      throw error(frame, site, Problem.NO_SUCH_FILE, to);
    }
  }

  /** Something that changes files. */
  interface Change {
    void run() throws IOException;
  }

  /** Makes a change that is quick. */
  static void change(Frame frame, CallSite site, UrbiPath path, Change change) {
    try {
      change.run();
    } catch (IOException e) {
      throw failed(frame, site, path, e);
    }
  }

  /** Makes a change that may take long, while the job waits. */
  void changeSlowly(Frame frame, CallSite site, UrbiPath path, Change change) {
    openSlowly(
        frame,
        site,
        path,
        () -> {
          change.run();
          return null;
        });
  }

  private static UrbiException failed(
      Frame frame, CallSite site, UrbiPath path, IOException failure) {
    return error(frame, site, reason(failure), path);
  }

  /** The text of a failure, in the words of the manual. */
  public static String reason(IOException failure) {
    return switch (failure) {
      case NoSuchFileException e -> Problem.NO_SUCH_FILE.text();
      case FileAlreadyExistsException e -> Problem.FILE_EXISTS.text();
      case DirectoryNotEmptyException e -> Problem.DIRECTORY_NOT_EMPTY.text();
      case AccessDeniedException e -> Problem.PERMISSION_DENIED.text();
      case NotDirectoryException e -> Problem.NOT_A_DIRECTORY.text();
      case FileSystemLoopException e -> Problem.TOO_MANY_LINKS.text();
      case FileNotFoundException e -> lowered(inParentheses(e));
      case FileSystemException e when e.getReason() != null -> lowered(e.getReason());
      default -> failure.getMessage() == null ? Problem.INPUT_OUTPUT.text() : failure.getMessage();
    };
  }

  /** The message of the machine, with which the JDK ends its own. */
  public static String inParentheses(IOException failure) {
    String message = String.valueOf(failure.getMessage());
    int from = message.lastIndexOf('(');
    int to = message.lastIndexOf(')');
    return from < 0 || to < from ? message : message.substring(from + 1, to);
  }

  /** A message of the machine as part of one of ours. */
  public static String lowered(String text) {
    return text.isEmpty()
        ? text
        : text.substring(0, 1).toLowerCase(Locale.ROOT) + text.substring(1);
  }
}
