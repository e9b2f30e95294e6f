package org.urbi.kernel.outside;

import java.io.Closeable;
import java.io.IOException;
import org.urbi.kernel.job.Job;

/** A destination for bytes; used on the kernel thread. */
public interface ByteSink extends Closeable {
  /**
   * Writes bytes, at once or in the background. The job waits while too many are pending.
   *
   * @throws IOException when they cannot be written
   */
  void write(Job job, byte[] bytes) throws IOException;

  /** Makes the job wait until everything is written. */
  void flush(Job job) throws IOException;
}
