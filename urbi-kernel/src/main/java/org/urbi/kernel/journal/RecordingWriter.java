package org.urbi.kernel.journal;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import java.util.zip.CRC32C;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.log.FailureLog;

/**
 * Writes entries to a file, block by block, on a thread of its own: the kernel never waits for the
 * disk. What cannot be written any more is told once; the run goes on without being recorded.
 */
public final class RecordingWriter implements AutoCloseable {
  /** What a recording begins with; the last octet is the version of the format. */
  static final byte[] MAGIC = {'U', 'R', 'B', 'I', 'R', 'U', 'N', 5};

  /** A block is its length, its CRC-32C, and whole entries. */
  static final int BLOCK_HEADER = 8;

  private static final int LARGE = 1 << 15;

  /** When more waits for the disk, the recording ends. */
  private static final long MOST_WAITING = 256L << 20;

  private static final long SECONDS_TO_END = 10;

  private static final byte[] END = new byte[0];

  private final OutputStream file;
  private final String name;
  private final Consumer<String> trouble;
  private final DataWriter entries = new DataWriter();
  private final ConcurrentLinkedQueue<byte[]> blocks = new ConcurrentLinkedQueue<>();
  private final AtomicLong waiting = new AtomicLong();
  private final Thread thread;
  private volatile boolean sleeping;
  private volatile boolean failed;

  /**
   * @param name of the file, for people
   * @param file written to at once, without a buffer
   * @param trouble told why there is no recording any more; on any thread
   */
  public RecordingWriter(String name, OutputStream file, Consumer<String> trouble) {
    this.name = name;
    this.file = file;
    this.trouble = trouble;
    blocks.add(MAGIC);
    thread = FailureLog.THREADS.platform("urbi-recorder", this::writeAll);
    thread.start();
  }

  /** Writes an entry, soon; by one thread. */
  public void write(Entry entry) {
    if (!failed) {
      EntryCodec.write(entries, entry);
      if (entries.length() > LARGE) {
        flush();
      }
    }
  }

  /** Has written what there is. */
  public void flush() {
    if (failed || entries.length() == 0) {
      return;
    }
    byte[] inside = entries.take();
    CRC32C checksum = new CRC32C();
    checksum.update(inside);
    pass(
        ByteBuffer.allocate(BLOCK_HEADER + inside.length)
            .putInt(inside.length)
            .putInt((int) checksum.getValue())
            .put(inside)
            .array());
    if (waiting.get() > MOST_WAITING) {
      fail("the disk is too slow");
    }
  }

  private void pass(byte[] block) {
    waiting.addAndGet(block.length);
    blocks.add(block);
    if (sleeping) {
      LockSupport.unpark(thread);
    }
  }

  private void fail(@Nullable String why) {
    if (!failed) {
      failed = true;
      trouble.accept("the run is not recorded any more: " + name + ": " + why);
    }
  }

  private void writeAll() {
    try (file) {
      for (byte[] block = next(); block != END; block = next()) {
        if (!failed) {
          file.write(block);
        }
        waiting.addAndGet(-block.length);
      }
    } catch (IOException e) {
      fail(e.getMessage());
    } catch (Throwable failure) {
      fail(FailureLog.text(failure));
      FailureLog.internal("the recorder", failure);
    }
  }

  private byte[] next() {
    byte[] block;
    while ((block = blocks.poll()) == null) {
      sleeping = true;
      if (blocks.isEmpty()) {
        LockSupport.park(this);
      }
      sleeping = false;
    }
    return block;
  }

  /** Writes what is left, and waits for that, but not for ever. */
  @Override
  public void close() {
    flush();
    pass(END);
    try {
      thread.join(Duration.ofSeconds(SECONDS_TO_END));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
