package org.urbi.kernel.outside;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.file.FileSystemLoopException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;

/**
 * The limits for what one kernel, or one kind of its clients, may do to the machine. All code in
 * this package that uses files, processes or connections checks here first.
 */
public final class Confinement {
  private static final int MOST_LINKS = 40;

  /** Null when all is allowed. */
  private final @Nullable Path directory;

  private final Path working;

  /** Whether nothing at all is allowed. */
  private final boolean closed;

  private Confinement(@Nullable Path directory, Path working, boolean closed) {
    this.directory = directory;
    this.working = working;
    this.closed = closed;
  }

  /**
   * The limits of a kernel whose run was recorded.
   *
   * @param directory the directory to which it was confined, or null
   * @param working the directory from which relative paths started
   */
  public static Confinement recorded(@Nullable String directory, String working) {
    return new Confinement(directory == null ? null : Path.of(directory), Path.of(working), false);
  }

  /** No limits except those of the operating system. */
  public static Confinement none() {
    return new Confinement(null, Path.of("").toAbsolutePath(), false);
  }

  /** Nothing is allowed. */
  public static Confinement total() {
    return new Confinement(null, Path.of("/"), true);
  }

  /**
   * Allows only files below that directory, after links are resolved; no processes and no
   * connections.
   *
   * @throws IOException when there is no such directory
   */
  public static Confinement to(Path directory) throws IOException {
    Path real = directory.toRealPath();
    if (!Files.isDirectory(real)) {
      throw new IOException(Problem.AT_PATH.text(Problem.NOT_A_DIRECTORY.text(), directory));
    }
    return new Confinement(real, real, false);
  }

  /** Whether anything is forbidden. */
  public boolean isConfined() {
    return closed || directory != null;
  }

  /** Whether any files are allowed. */
  public boolean allowsFiles() {
    return !closed;
  }

  /** The initial directory for relative paths. */
  public Path workingDirectory() {
    return working;
  }

  /**
   * The file to which a path leads when links are followed.
   *
   * @throws ConfinedException if it may not be used
   */
  Path followed(Path path) throws IOException {
    checkFiles();
    return directory == null ? path : checked(directory, resolved(path));
  }

  /**
   * The entry of a directory that a path names, which may be a link.
   *
   * @throws ConfinedException when it may not be used
   */
  Path entry(Path path) throws IOException {
    checkFiles();
    Path name = path.getFileName();
    return directory == null || name == null
        ? followed(path)
        : checked(directory, resolved(directoryOf(path)).resolve(name));
  }

  /**
   * The entry that is to be created, renamed or deleted: not the directory of the kernel itself.
   *
   * @throws ConfinedException when it may not be used
   */
  Path changed(Path path) throws IOException {
    Path entry = entry(path);
    if (entry.equals(directory)) {
      throw new ConfinedException(Problem.CONFINED_DIRECTORY);
    }
    return entry;
  }

  private void checkFiles() throws ConfinedException {
    if (closed) {
      throw new ConfinedException(Problem.CONFINED_FILES);
    }
  }

  private static Path directoryOf(Path path) {
    return requireNonNull(path.getParent(), "all paths are absolute");
  }

  private static Path checked(Path directory, Path resolved) throws ConfinedException {
    if (!resolved.startsWith(directory)) {
      throw new ConfinedException(Problem.CONFINED_OUTSIDE);
    }
    return resolved;
  }

  /** The path without links, whether or not such a file exists. */
  private static Path resolved(Path path) throws IOException {
    Deque<Path> names = new ArrayDeque<>();
    path.forEach(names::addLast);
    Path current = path.getRoot();
    int links = 0;
    while (!names.isEmpty()) {
      Path name = names.removeFirst();
      Path next = current.resolve(name);
      if (name.toString().equals("..")) {
        current = current.getParent() == null ? current : current.getParent();
      } else if (name.toString().isEmpty() || name.toString().equals(".")) {
        continue;
      } else if (Files.isSymbolicLink(next)) {
        if (++links > MOST_LINKS) {
          throw new FileSystemLoopException(path.toString());
        }
        Path target = Files.readSymbolicLink(next);
        for (int i = target.getNameCount() - 1; i >= 0; i--) {
          names.addFirst(target.getName(i));
        }
        current = target.isAbsolute() ? target.getRoot() : current;
      } else {
        current = next;
      }
    }
    return current;
  }

  /** Refuses to start a program if that is not allowed. */
  void checkProcesses() throws ConfinedException {
    if (isConfined()) {
      throw new ConfinedException(Problem.CONFINED_PROCESSES);
    }
  }

  /** Refuses to load native or Java code, which a program could have written to a file. */
  public void checkModules() throws ConfinedException {
    if (isConfined()) {
      throw new ConfinedException(Problem.CONFINED_MODULES);
    }
  }

  /** Refuses connections, over the network or a serial line, if they are not allowed. */
  public void checkConnections() throws ConfinedException {
    if (isConfined()) {
      throw new ConfinedException(Problem.CONFINED_CONNECTIONS);
    }
  }
}
