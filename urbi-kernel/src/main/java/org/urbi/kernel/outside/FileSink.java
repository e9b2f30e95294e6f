package org.urbi.kernel.outside;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import org.urbi.kernel.job.Job;

/** The end of a regular file. What is written is there for everybody at once. */
public final class FileSink implements ByteSink {
  private final Outside outside;
  private final FileChannel channel;

  FileSink(Outside outside, FileChannel channel) {
    this.outside = outside;
    this.channel = channel;
  }

  @Override
  public void write(Job job, byte[] bytes) throws IOException {
    outside.look(() -> {
      ByteBuffer rest = ByteBuffer.wrap(bytes);
      while (rest.hasRemaining()) {
        channel.write(rest);
      }
      return null;
    });
  }

  @Override
  public void flush(Job job) {}

  @Override
  public void close() throws IOException {
    if (channel != null) {
      channel.close();
    }
  }
}
