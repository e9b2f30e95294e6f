package org.urbi.server.studio.mcap;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.urbi.server.studio.messages.LittleEndianBuffer;

/** Messages that are written together, with an index of each of their channels. */
final class McapChunk {
  private static final int CHUNK = 0x06;
  private static final int MESSAGE_INDEX = 0x07;
  private static final int CHUNK_INDEX = 0x08;
  private static final int MESSAGE = 0x05;

  private record Entry(long time, long offset) {}

  private final LittleEndianBuffer records = new LittleEndianBuffer();
  private final Map<Integer, List<Entry>> entries = new TreeMap<>();
  private long first = Long.MAX_VALUE;
  private long last;
  private int messages;

  /** How many messages it has so far. */
  int messages() {
    return messages;
  }

  /** How many bytes it has so far. */
  int size() {
    return records.size();
  }

  /** Adds a record that is no message: a schema, or a channel. */
  void add(int opcode, LittleEndianBuffer content) {
    records.record(opcode, content);
  }

  /**
   * Adds a message.
   *
   * @param sequence its number among those of its channel
   * @param time in nanoseconds since the Epoch
   */
  void add(int channel, int sequence, long time, byte[] content) {
    entries.computeIfAbsent(channel, any -> new ArrayList<>()).add(new Entry(time, records.size()));
    messages++;
    first = Math.min(first, time);
    last = Math.max(last, time);
    records.record(
        MESSAGE,
        new LittleEndianBuffer()
            .shortNumber(channel)
            .number(sequence)
            .longNumber(time)
            .longNumber(time)
            .raw(content));
  }

  /**
   * Appends it to what is to be written, with its indexes.
   *
   * @param position in the file, of the first byte of what is to be written
   * @return its index for the summary
   */
  LittleEndianBuffer write(LittleEndianBuffer out, long position) {
    long start = position + out.size();
    long begin = entries.isEmpty() ? 0 : first;
    LittleEndianBuffer chunk =
        new LittleEndianBuffer()
            .longNumber(begin)
            .longNumber(last)
            .longNumber(records.size())
            .number(records.crc())
            .text("")
            .longNumber(records.size())
            .raw(records.toBytes());
    out.record(CHUNK, chunk);
    long end = position + out.size();
    Map<Integer, Long> offsets = new TreeMap<>();
    entries.forEach((channel, of) -> {
      offsets.put(channel, position + out.size());
      LittleEndianBuffer index = new LittleEndianBuffer();
      of.forEach(each -> index.longNumber(each.time).longNumber(each.offset));
      out.record(
          MESSAGE_INDEX, new LittleEndianBuffer().shortNumber(channel).block(index.toBytes()));
    });
    return new LittleEndianBuffer()
        .record(
            CHUNK_INDEX,
            new LittleEndianBuffer()
                .longNumber(begin)
                .longNumber(last)
                .longNumber(start)
                .longNumber(end - start)
                .counts(offsets)
                .longNumber(position + out.size() - end)
                .text("")
                .longNumber(records.size())
                .longNumber(records.size()));
  }
}
