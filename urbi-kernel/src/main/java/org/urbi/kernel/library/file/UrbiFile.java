package org.urbi.kernel.library.file;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** A file (manual, "File"). */
final class UrbiFile extends FileSystemEntry {
  UrbiFile(Shape shape, @Nullable UrbiPath path) {
    super(shape, path);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiFile(cloneShape(), path());
  }
}
