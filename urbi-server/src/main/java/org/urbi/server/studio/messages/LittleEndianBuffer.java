package org.urbi.server.studio.messages;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.zip.CRC32;

/**
 * Bytes as MCAP and ROS 2 have them: numbers little-endian; strings, records and blocks after their
 * length.
 */
public final class LittleEndianBuffer {
  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

  private LittleEndianBuffer number(long value, int size) {
    for (int i = 0; i < size; i++) {
      bytes.write((int) (value >>> (Byte.SIZE * i)));
    }
    return this;
  }

  /** The last eight bits of a number. */
  public LittleEndianBuffer octet(int value) {
    return number(value, 1);
  }

  /** The last 16 bits of a number. */
  public LittleEndianBuffer shortNumber(int value) {
    return number(value, Short.BYTES);
  }

  /** 32 bits. */
  public LittleEndianBuffer number(int value) {
    return number(value, Integer.BYTES);
  }

  /** 64 bits. */
  public LittleEndianBuffer longNumber(long value) {
    return number(value, Long.BYTES);
  }

  /** Bytes as they are. */
  public LittleEndianBuffer raw(byte[] value) {
    bytes.writeBytes(value);
    return this;
  }

  /** Bytes after their length. */
  public LittleEndianBuffer block(byte[] value) {
    return number(value.length).raw(value);
  }

  /** A text in UTF-8, after its length in bytes. */
  public LittleEndianBuffer text(String value) {
    return block(value.getBytes(StandardCharsets.UTF_8));
  }

  /** A map from numbers of channels to offsets or counts. */
  public LittleEndianBuffer counts(Map<Integer, Long> values) {
    number(values.size() * (Short.BYTES + Long.BYTES));
    values.forEach((key, value) -> shortNumber(key).longNumber(value));
    return this;
  }

  /** A record of MCAP: its kind, its length, and what is in it. */
  public LittleEndianBuffer record(int opcode, LittleEndianBuffer content) {
    return octet(opcode).longNumber(content.size()).raw(content.toBytes());
  }

  /** How many bytes there are. */
  public int size() {
    return bytes.size();
  }

  /** A copy of them. */
  public byte[] toBytes() {
    return bytes.toByteArray();
  }

  /** The checksum of the bytes. */
  public int crc() {
    CRC32 crc = new CRC32();
    crc.update(toBytes());
    return (int) crc.getValue();
  }

  /** Forgets them. */
  public void clear() {
    bytes.reset();
  }
}
