package org.urbi.server.studio.mcap;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.zip.CRC32;

/** Bytes as MCAP has them: numbers little-endian, strings and records after their length. */
final class McapBuffer {
  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

  private McapBuffer number(long value, int size) {
    for (int i = 0; i < size; i++) {
      bytes.write((int) (value >>> (Byte.SIZE * i)));
    }
    return this;
  }

  McapBuffer octet(int value) {
    return number(value, 1);
  }

  McapBuffer shortNumber(int value) {
    return number(value, Short.BYTES);
  }

  McapBuffer number(int value) {
    return number(value, Integer.BYTES);
  }

  McapBuffer longNumber(long value) {
    return number(value, Long.BYTES);
  }

  McapBuffer raw(byte[] value) {
    bytes.writeBytes(value);
    return this;
  }

  /** Bytes after their length. */
  McapBuffer block(byte[] value) {
    return number(value.length).raw(value);
  }

  McapBuffer text(String value) {
    return block(value.getBytes(StandardCharsets.UTF_8));
  }

  /** A map from numbers of channels to offsets or counts. */
  McapBuffer counts(Map<Integer, Long> values) {
    number(values.size() * (Short.BYTES + Long.BYTES));
    values.forEach((key, value) -> shortNumber(key).longNumber(value));
    return this;
  }

  /** A record. */
  McapBuffer record(int opcode, McapBuffer content) {
    return octet(opcode).longNumber(content.size()).raw(content.toBytes());
  }

  int size() {
    return bytes.size();
  }

  byte[] toBytes() {
    return bytes.toByteArray();
  }

  /** The checksum of the bytes. */
  int crc() {
    CRC32 crc = new CRC32();
    crc.update(toBytes());
    return (int) crc.getValue();
  }

  void clear() {
    bytes.reset();
  }
}
