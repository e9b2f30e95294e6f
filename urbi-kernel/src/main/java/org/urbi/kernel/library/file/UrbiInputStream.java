package org.urbi.kernel.library.file;

import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.outside.ByteSource;

/** Reads bytes one after the other (manual, "InputStream"). */
public final class UrbiInputStream extends UrbiStream<ByteSource> {
  UrbiInputStream(Shape shape, ByteSource source) {
    super(shape, source);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiInputStream(cloneShape(), null);
  }
}
