package org.urbi.kernel.outside;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;

/**
 * Appends to a regular file. What is written is visible to everybody at once, unless it is much:
 * then it is written in pieces on another thread, between which others run. What is written
 * meanwhile comes after it.
 */
public final class FileSink implements ByteSink {
  /** As much as the kernel thread writes itself. */
  private static final int LARGE = 1 << 18;

  private final Outside outside;
  private final WaitingJobs waiters = new WaitingJobs();

  /** Whether a job is writing pieces. */
  private boolean writing;

  /** Null in a replay. */
  private final @Nullable FileChannel channel;

  FileSink(Outside outside, @Nullable FileChannel channel) {
    this.outside = outside;
    this.channel = channel;
  }

  @Override
  public void write(Job job, byte[] bytes) throws IOException {
    waiters.await(job, () -> !writing);
    if (bytes.length <= LARGE) {
      outside.change(() -> append(ByteBuffer.wrap(bytes)));
      return;
    }
    writing = true;
    try {
      for (int from = 0; from < bytes.length; from += LARGE) {
        ByteBuffer piece = ByteBuffer.wrap(bytes, from, Math.min(LARGE, bytes.length - from));
        outside.awaitOpen(
            job,
            () -> {
              append(piece);
              return null;
            });
      }
    } finally {
      writing = false;
      waiters.wake();
    }
  }

  private void append(ByteBuffer rest) throws IOException {
    FileChannel live = Outside.live(channel);
    while (rest.hasRemaining()) {
      live.write(rest);
    }
  }

  @Override
  public void flush(Job job) {
    waiters.await(job, () -> !writing);
  }

  @Override
  public void close() throws IOException {
    if (channel != null) {
      channel.close();
    }
  }
}
