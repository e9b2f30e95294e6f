package org.urbi.kernel.outside;

import java.io.Closeable;
import java.io.IOException;
import org.urbi.kernel.job.Job;

/** A source of bytes, which are read one after the other; used on the kernel thread. */
public interface ByteSource extends Closeable {
  /**
   * The next byte, -1 at the end. The job waits until there is one.
   *
   * @throws IOException when it cannot be read
   */
  int read(Job job) throws IOException;
}
