package org.urbi.kernel.library.file;

import static java.util.Objects.requireNonNull;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** An entry of the file system: a file or a directory. */
abstract class FileSystemEntry extends UrbiObject {
  private @Nullable UrbiPath path;

  FileSystemEntry(Shape shape, @Nullable UrbiPath path) {
    super(shape);
    this.path = path;
  }

  /** Where it is; null of the prototype. */
  @Nullable UrbiPath path() {
    return path;
  }

  void setPath(UrbiPath other) {
    path = other;
  }

  private UrbiPath own() {
    return requireNonNull(path, "nothing is asked of the prototype");
  }

  /** The path as the machine knows it. */
  Path file() {
    return own().file();
  }

  /** The path as urbiscript shows it. */
  String text() {
    return own().text();
  }
}
