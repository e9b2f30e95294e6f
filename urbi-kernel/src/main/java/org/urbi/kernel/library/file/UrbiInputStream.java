package org.urbi.kernel.library.file;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.outside.ByteSource;

/** Reads bytes one after the other (manual, "InputStream"). */
public final class UrbiInputStream extends UrbiStream<ByteSource> {
  UrbiInputStream(Shape shape, @Nullable ByteSource source) {
    super(shape, source);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiInputStream(cloneShape(), null);
  }
}
