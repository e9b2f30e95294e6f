package org.urbi.kernel.library.file;

import java.nio.file.Path;

/** Where relative paths start from: one for each kernel, shared by all its paths. */
public final class WorkingDirectory {
  private Path path;

  public WorkingDirectory(Path path) {
    this.path = path;
  }

  public Path path() {
    return path;
  }

  void move(Path other) {
    path = other;
  }
}
