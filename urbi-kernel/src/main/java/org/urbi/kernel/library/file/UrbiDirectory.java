package org.urbi.kernel.library.file;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** A directory (manual, "Directory"). */
final class UrbiDirectory extends FileSystemEntry {
  UrbiDirectory(Shape shape, @Nullable UrbiPath path) {
    super(shape, path);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiDirectory(cloneShape(), path());
  }
}
