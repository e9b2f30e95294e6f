package org.urbi.kernel.outside;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;

/** The bytes of a regular file. */
public final class FileSource implements ByteSource {
  private static final int BUFFER = 1 << 13;

  private final Outside outside;

  /** Null in a replay. */
  private final @Nullable FileChannel channel;

  private byte[] bytes = new byte[0];
  private int position;

  FileSource(Outside outside, @Nullable FileChannel channel) {
    this.outside = outside;
    this.channel = channel;
  }

  @Override
  public int read(Job job) throws IOException {
    if (position == bytes.length) {
      bytes = outside.query(this::readSome);
      position = 0;
    }
    return bytes.length == 0 ? -1 : bytes[position++] & 0xff;
  }

  private byte[] readSome() throws IOException {
    ByteBuffer buffer = ByteBuffer.allocate(BUFFER);
    Outside.live(channel).read(buffer);
    return Arrays.copyOf(buffer.array(), buffer.position());
  }

  @Override
  public void close() throws IOException {
    if (channel != null) {
      channel.close();
    }
  }
}
