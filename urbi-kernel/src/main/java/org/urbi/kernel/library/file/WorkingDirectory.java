package org.urbi.kernel.library.file;

import java.nio.file.Path;
import org.urbi.kernel.outside.Outside;

/**
 * Where relative paths start from: one for each kernel, shared by all its paths, but for code that
 * has a directory of its own.
 */
public final class WorkingDirectory {
  private final Outside outside;
  private Path path;

  public WorkingDirectory(Outside outside, Path path) {
    this.outside = outside;
    this.path = path;
  }

  public Path path() {
    return outside.startOfPaths(path);
  }

  void move(Path other) {
    path = other;
  }
}
