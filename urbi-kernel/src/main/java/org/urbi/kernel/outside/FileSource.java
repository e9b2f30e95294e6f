package org.urbi.kernel.outside;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;

/** The bytes of a regular file. */
public final class FileSource implements ByteSource {
  private static final int BUFFER = 1 << 13;

  private final Outside outside;
  private final Path path;
  private final boolean mayWait;

  /** Null in a replay. */
  private final @Nullable FileChannel channel;

  private byte[] bytes = new byte[0];
  private int position;

  /**
   * @param mayWait whether readers may have to wait, as those of files of the operating system
   *     (proc(5)) that seem to be empty
   */
  FileSource(Outside outside, Path path, boolean mayWait, @Nullable FileChannel channel) {
    this.outside = outside;
    this.path = path;
    this.mayWait = mayWait;
    this.channel = channel;
  }

  @Override
  public int read(Job job) throws IOException {
    if (position == bytes.length) {
      bytes =
          mayWait
              ? requireNonNull(outside.awaitBriefly(job, path, this::readSome), "bytes, or none")
              : outside.query(this::readSome);
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
