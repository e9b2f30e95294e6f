package org.urbi.ros.rtps;

import java.nio.ByteBuffer;

/**
 * The twelve bytes that identify a participant, and begin the identifiers of its writers and
 * readers.
 */
public record GuidPrefix(int first, int second, int third) {
  static final GuidPrefix UNKNOWN = new GuidPrefix(0, 0, 0);

  /** The next twelve bytes of {@code in}, whatever its byte order. */
  static GuidPrefix read(ByteBuffer in) {
    return new GuidPrefix(Wire.bigEndian(in), Wire.bigEndian(in), Wire.bigEndian(in));
  }

  void write(ByteBuffer out) {
    Wire.putBigEndian(out, first);
    Wire.putBigEndian(out, second);
    Wire.putBigEndian(out, third);
  }

  @Override
  public String toString() {
    return String.format("%08x.%08x.%08x", first, second, third);
  }
}
