package org.urbi.kernel.outside;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;

/** Appends to a regular file. What is written is visible to everybody at once. */
public final class FileSink implements ByteSink {
  private final Outside outside;

  /** Null in a replay. */
  private final @Nullable FileChannel channel;

  FileSink(Outside outside, @Nullable FileChannel channel) {
    this.outside = outside;
    this.channel = channel;
  }

  @Override
  public void write(Job job, byte[] bytes) throws IOException {
    outside.change(() -> {
      FileChannel live = Outside.live(channel);
      ByteBuffer rest = ByteBuffer.wrap(bytes);
      while (rest.hasRemaining()) {
        live.write(rest);
      }
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
