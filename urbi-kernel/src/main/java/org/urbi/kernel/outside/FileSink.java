package org.urbi.kernel.outside;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.urbi.kernel.job.Job;

/** The end of a regular file. What is written is there for everybody at once. */
public final class FileSink implements ByteSink {
  private final FileChannel channel;

  FileSink(Path file) throws IOException {
    channel = FileChannel.open(file, StandardOpenOption.WRITE, StandardOpenOption.APPEND);
  }

  @Override
  public void write(Job job, byte[] bytes) throws IOException {
    ByteBuffer rest = ByteBuffer.wrap(bytes);
    while (rest.hasRemaining()) {
      channel.write(rest);
    }
  }

  @Override
  public void flush(Job job) {}

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
