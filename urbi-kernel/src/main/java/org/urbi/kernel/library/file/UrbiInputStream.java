package org.urbi.kernel.library.file;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Forgotten;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.outside.ByteSource;
import org.urbi.kernel.outside.PipeSource;

/** Reads bytes one after the other (manual, "InputStream"). */
public final class UrbiInputStream extends UrbiStream<ByteSource> {
  UrbiInputStream(Shape shape, @Nullable ByteSource source) {
    super(shape, source);
  }

  /**
   * Reads a pipe, for which a thread waits: nothing else ends it if the stream is forgotten, as by
   * a job that is stopped in the middle.
   */
  void openPipe(PipeSource source) {
    open(source);
    Forgotten.whenGone(this, source::close);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiInputStream(cloneShape(), null);
  }
}
