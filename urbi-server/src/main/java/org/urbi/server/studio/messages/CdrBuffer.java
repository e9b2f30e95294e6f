package org.urbi.server.studio.messages;

import java.nio.charset.StandardCharsets;
import java.util.List;

/** A message as ROS 2 writes it (CDR): little-endian, each number at a multiple of its size. */
final class CdrBuffer {
  private static final byte[] LITTLE_ENDIAN = {0, 1, 0, 0};

  /** The header, from whose end multiples are counted, and what follows it. */
  private final LittleEndianBuffer content = new LittleEndianBuffer().raw(LITTLE_ENDIAN);

  private LittleEndianBuffer aligned(int size) {
    while ((content.size() - LITTLE_ENDIAN.length) % size != 0) {
      content.octet(0);
    }
    return content;
  }

  CdrBuffer octet(int value) {
    content.octet(value);
    return this;
  }

  CdrBuffer number(int value) {
    aligned(Integer.BYTES).number(value);
    return this;
  }

  CdrBuffer real(double value) {
    aligned(Double.BYTES).longNumber(Double.doubleToRawLongBits(value));
    return this;
  }

  /** A text in UTF-8; its length counts the zero at its end. */
  CdrBuffer text(String value) {
    byte[] bytes = value.getBytes(StandardCharsets.UTF_8);
    number(bytes.length + 1);
    content.raw(bytes).octet(0);
    return this;
  }

  /** Bytes after their length. */
  CdrBuffer block(byte[] value) {
    number(value.length);
    content.raw(value);
    return this;
  }

  /** Numbers after their count. */
  CdrBuffer reals(List<Double> values) {
    number(values.size());
    values.forEach(this::real);
    return this;
  }

  byte[] toBytes() {
    return content.toBytes();
  }
}
