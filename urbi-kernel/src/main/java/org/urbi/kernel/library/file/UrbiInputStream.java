package org.urbi.kernel.library.file;

import java.lang.ref.Cleaner;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.outside.ByteSource;
import org.urbi.kernel.outside.PipeSource;

/** Reads bytes one after the other (manual, "InputStream"). */
public final class UrbiInputStream extends UrbiStream<ByteSource> {
  /** Holds the cleaner, which has a thread, so that it is created only with the first pipe. */
  private static final class Forgotten {
    static final Cleaner CLEANER = Cleaner.create();
  }

  UrbiInputStream(Shape shape, @Nullable ByteSource source) {
    super(shape, source);
  }

  /**
   * Reads a pipe, for which a thread waits: nothing else ends it if the stream is forgotten, as by
   * a job that is stopped in the middle.
   */
  void openPipe(PipeSource source) {
    open(source);
    Forgotten.CLEANER.register(this, source::close);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiInputStream(cloneShape(), null);
  }
}
