package org.urbi.kernel.library.file;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.outside.ByteSink;

/** Writes bytes (manual, "OutputStream"). */
final class UrbiOutputStream extends UrbiStream<ByteSink> {
  UrbiOutputStream(Shape shape, @Nullable ByteSink sink) {
    super(shape, sink);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiOutputStream(cloneShape(), null);
  }
}
