package org.urbi.kernel.outside;

import java.io.Closeable;
import java.io.IOException;
import org.urbi.kernel.job.Job;

/** Where bytes are written; on the kernel thread. */
public interface ByteSink extends Closeable {
  /**
   * Writes bytes, at once or soon. The job waits while too many are under way.
   *
   * @throws IOException when they cannot be written
   */
  void write(Job job, byte[] bytes) throws IOException;

  /** The job waits until all is written. */
  void flush(Job job) throws IOException;
}
