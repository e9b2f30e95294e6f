package org.urbi.kernel.library.file;

import java.nio.file.Path;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** What is in the file system under a path: a file or a directory. */
abstract class UrbiEntry extends UrbiObject {
  private UrbiPath path;

  UrbiEntry(Shape shape, UrbiPath path) {
    super(shape);
    this.path = path;
  }

  UrbiPath path() {
    return path;
  }

  void setPath(UrbiPath other) {
    path = other;
  }

  /** The path as the machine knows it. */
  Path file() {
    return path.file();
  }

  /** The path as urbiscript shows it. */
  String text() {
    return path.text();
  }
}
