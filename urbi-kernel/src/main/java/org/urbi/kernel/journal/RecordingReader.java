package org.urbi.kernel.journal;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.zip.CRC32C;
import org.jspecify.annotations.Nullable;
import urbi.wire.WireException;

/**
 * Reads the entries of a recording, one after the other. One that was cut off, because the process
 * that wrote it was killed, can be read up to its last whole block.
 */
public final class RecordingReader implements AutoCloseable {
  private static final int LONGEST_BLOCK = 1 << 30;

  private final DataInputStream in;
  private final ArrayDeque<Entry> entries = new ArrayDeque<>();
  private long position = RecordingWriter.MAGIC.length;
  private boolean cutOff;

  /**
   * @param file read from its beginning
   * @throws RecordingException if it is no recording, or one of another format
   */
  public RecordingReader(InputStream file) {
    in = new DataInputStream(file);
    try {
      byte[] magic = in.readNBytes(RecordingWriter.MAGIC.length);
      int last = RecordingWriter.MAGIC.length - 1;
      if (magic.length <= last || !Arrays.equals(magic, 0, last, RecordingWriter.MAGIC, 0, last)) {
        throw new RecordingException("is no recording of urbi");
      }
      if (magic[last] != RecordingWriter.MAGIC[last]) {
        throw new RecordingException(
            "has version "
                + magic[last]
                + " of the format, not "
                + RecordingWriter.MAGIC[last]
                + ": it is of another urbi");
      }
    } catch (IOException e) {
      throw new RecordingException("cannot be read: " + e.getMessage());
    }
  }

  /**
   * The next entry, or null at the end.
   *
   * @throws RecordingException if the file is damaged
   */
  public @Nullable Entry next() {
    while (entries.isEmpty() && !cutOff) {
      byte[] block = block();
      if (block == null) {
        return null;
      }
      read(block);
    }
    return entries.poll();
  }

  /** Whether the end of the recording is missing; known when {@link #next} has returned null. */
  public boolean isCutOff() {
    return cutOff;
  }

  private byte @Nullable [] block() {
    try {
      int first = in.read();
      if (first < 0) {
        return null;
      }
      int length =
          first << 24
              | in.readUnsignedByte() << 16
              | in.readUnsignedByte() << 8
              | in.readUnsignedByte();
      int checksum = in.readInt();
      if (length <= 0 || length > LONGEST_BLOCK) {
        throw damaged();
      }
      byte[] block = in.readNBytes(length);
      if (block.length < length) {
        cutOff = true;
        return null;
      }
      CRC32C real = new CRC32C();
      real.update(block);
      if ((int) real.getValue() != checksum) {
        throw damaged();
      }
      position += RecordingWriter.BLOCK_HEADER + length;
      return block;
    } catch (EOFException e) {
      cutOff = true;
      return null;
    } catch (IOException e) {
      throw new RecordingException("cannot be read: " + e.getMessage());
    }
  }

  private RecordingException damaged() {
    return new RecordingException("is damaged at byte " + position);
  }

  private void read(byte[] block) {
    DataReader data = new DataReader(block);
    try {
      while (data.hasMore()) {
        entries.add((Entry) EntryCodec.read(data));
      }
    } catch (WireException | ClassCastException e) {
      throw damaged();
    }
  }

  @Override
  public void close() throws IOException {
    in.close();
  }
}
