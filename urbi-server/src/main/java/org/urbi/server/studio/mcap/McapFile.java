package org.urbi.server.studio.mcap;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.TreeMap;
import org.urbi.server.studio.messages.Form;
import org.urbi.server.studio.messages.LittleEndianBuffer;

/**
 * An MCAP file (mcap.dev) that is being written: messages in chunks, which are not compressed. What
 * has been {@linkplain #flush flushed} can be read although the file was never closed; closing it
 * adds the summary, by which readers find what they look for.
 */
final class McapFile implements Closeable {
  /** The size at which a chunk is written by itself, in bytes. */
  private static final int LARGE = 1 << 20;

  private static final byte[] MAGIC = "\u0089MCAP0\r\n".getBytes(StandardCharsets.ISO_8859_1);
  private static final int HEADER = 0x01;
  private static final int FOOTER = 0x02;
  private static final int SCHEMA = 0x03;
  private static final int CHANNEL = 0x04;
  private static final int CHUNK_INDEX = 0x08;
  private static final int STATISTICS = 0x0b;
  private static final int SUMMARY_OFFSET = 0x0e;
  private static final int DATA_END = 0x0f;

  /** How many bytes are written at a time, so that it can be told whether the disk takes any. */
  private static final int PIECE = 1 << 16;

  /** A footer's opcode, its length, and its content without the checksum. */
  private static final int FOOTER_CONTENT = 2 * Long.BYTES + Integer.BYTES;

  /** More would have numbers of more than 16 bits. */
  private static final int MOST_CHANNELS = 65_000;

  private final FileChannel file;
  private final Map<String, Integer> schemas = new LinkedHashMap<>();
  private final Map<Integer, Long> counts = new TreeMap<>();

  /** What is repeated in the summary, which finds it without reading the rest. */
  private final LittleEndianBuffer schemaRecords = new LittleEndianBuffer();

  private final LittleEndianBuffer channelRecords = new LittleEndianBuffer();
  private final LittleEndianBuffer chunkIndexes = new LittleEndianBuffer();
  private McapChunk chunk = new McapChunk();
  private int channels;
  private int chunks;
  private long messages;

  /** Read by those who wait for the thread that writes. */
  private volatile long written;

  private volatile int unwritten;
  private long first = Long.MAX_VALUE;
  private long last;

  /**
   * Begins a file; one that is there is overwritten.
   *
   * @param library what writes it
   * @throws IOException if it cannot be written, or is no regular file: a pipe and a device may
   *     have whoever writes wait for ever, and have no places, of which the summary tells
   */
  McapFile(Path path, String library) throws IOException {
    if (Files.exists(path) && !Files.isRegularFile(path)) {
      throw new FileSystemException(path.toString(), null, "not a regular file");
    }
    file =
        FileChannel.open(
            path,
            StandardOpenOption.CREATE,
            StandardOpenOption.TRUNCATE_EXISTING,
            StandardOpenOption.WRITE);
    try {
      write(
          new LittleEndianBuffer()
              .raw(MAGIC)
              .record(HEADER, new LittleEndianBuffer().text("").text(library)));
    } catch (IOException e) {
      file.close();
      throw e;
    }
  }

  /**
   * Declares a channel.
   *
   * @param form of its messages; those with the same name of a schema have the same schema
   * @return its number; -1 when there are too many
   */
  int channel(String topic, Form form) {
    if (channels == MOST_CHANNELS) {
      return -1;
    }
    Integer known = schemas.get(form.schemaName());
    if (known == null) {
      known = schemas.size() + 1;
      schemas.put(form.schemaName(), known);
      declare(
          SCHEMA,
          new LittleEndianBuffer()
              .shortNumber(known)
              .text(form.schemaName())
              .text(form.schemaEncoding())
              .text(form.schema()),
          schemaRecords);
    }
    int number = ++channels;
    declare(
        CHANNEL,
        new LittleEndianBuffer()
            .shortNumber(number)
            .shortNumber(known)
            .text(topic)
            .text(form.messageEncoding())
            .number(0),
        channelRecords);
    return number;
  }

  private void declare(int opcode, LittleEndianBuffer content, LittleEndianBuffer summary) {
    chunk.add(opcode, content);
    summary.record(opcode, content);
  }

  /**
   * Adds a message.
   *
   * @param channel its number
   * @param time in nanoseconds since the Epoch
   * @throws IOException if a chunk is full and cannot be written: see {@link #flush}
   */
  void message(int channel, long time, byte[] content) throws IOException {
    long count = counts.merge(channel, 1L, Long::sum);
    chunk.add(channel, (int) count, time, content);
    messages++;
    unwritten = chunk.messages();
    first = Math.min(first, time);
    last = Math.max(last, time);
    if (chunk.size() >= LARGE) {
      flush();
    }
  }

  /** Whether something has not been written yet. */
  boolean isPending() {
    return chunk.size() > 0;
  }

  /**
   * Writes what has been added so far.
   *
   * @throws IOException if it cannot be written; then the file ends after what was flushed before
   */
  void flush() throws IOException {
    if (isPending()) {
      LittleEndianBuffer out = new LittleEndianBuffer();
      LittleEndianBuffer index = chunk.write(out, file.position());
      write(out);
      chunkIndexes.raw(index.toBytes());
      chunks++;
      chunk = new McapChunk();
      unwritten = 0;
    }
  }

  /** Writes all, or nothing: half a record at the end would be an error for readers. */
  private void write(LittleEndianBuffer out) throws IOException {
    long before = file.position();
    ByteBuffer bytes = ByteBuffer.wrap(out.toBytes());
    try {
      while (bytes.hasRemaining()) {
        int count = file.write(bytes.slice(bytes.position(), Math.min(PIECE, bytes.remaining())));
        bytes.position(bytes.position() + count);
        written = before + bytes.position();
      }
    } catch (IOException e) {
      try {
        file.truncate(before);
      } catch (IOException unable) {
        e.addSuppressed(unable);
      }
      throw e;
    }
  }

  /** How many bytes the disk has taken; from any thread. */
  long written() {
    return written;
  }

  /** How many messages have been added, and not written; from any thread. */
  int unwritten() {
    return unwritten;
  }

  /** Writes what is left, and the summary. */
  @Override
  public void close() throws IOException {
    try (file) {
      flush();
      LittleEndianBuffer end =
          new LittleEndianBuffer().record(DATA_END, new LittleEndianBuffer().number(0));
      long start = file.position() + end.size();
      LittleEndianBuffer summary = summary(start);
      LittleEndianBuffer footer = new LittleEndianBuffer();
      footer
          .octet(FOOTER)
          .longNumber(FOOTER_CONTENT)
          .longNumber(start)
          .longNumber(start + offsetsAt());
      LittleEndianBuffer checked =
          new LittleEndianBuffer().raw(summary.toBytes()).raw(footer.toBytes());
      write(end.raw(checked.toBytes()).number(checked.crc()).raw(MAGIC));
    }
  }

  /** Frees the file as it is, if it was not {@linkplain #close closed}: nothing is written. */
  void release() {
    try {
      file.close();
    } catch (IOException e) {
      // The disk has lost what was there: that it takes nothing was told before.
    }
  }

  private LittleEndianBuffer statistics() {
    LittleEndianBuffer content =
        new LittleEndianBuffer()
            .longNumber(messages)
            .shortNumber(schemas.size())
            .number(channels)
            .number(0)
            .number(0)
            .number(chunks)
            .longNumber(messages == 0 ? 0 : first)
            .longNumber(last)
            .counts(counts);
    return new LittleEndianBuffer().record(STATISTICS, content);
  }

  /** Where in the summary its own index begins. */
  private long offsetsAt() {
    return (long) schemaRecords.size()
        + channelRecords.size()
        + statistics().size()
        + chunkIndexes.size();
  }

  private LittleEndianBuffer summary(long start) {
    Map<Integer, LittleEndianBuffer> groups = new LinkedHashMap<>();
    groups.put(SCHEMA, schemaRecords);
    groups.put(CHANNEL, channelRecords);
    groups.put(STATISTICS, statistics());
    groups.put(CHUNK_INDEX, chunkIndexes);
    LittleEndianBuffer summary = new LittleEndianBuffer();
    LittleEndianBuffer offsets = new LittleEndianBuffer();
    groups.forEach((opcode, records) -> {
      if (records.size() > 0) {
        offsets.record(
            SUMMARY_OFFSET,
            new LittleEndianBuffer()
                .octet(opcode)
                .longNumber(start + summary.size())
                .longNumber(records.size()));
        summary.raw(records.toBytes());
      }
    });
    return summary.raw(offsets.toBytes());
  }
}
