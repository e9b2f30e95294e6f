package org.urbi.ros.rtps;

import java.nio.ByteBuffer;

/** The sixteen bytes that identify a participant, a writer or a reader. */
public record Guid(GuidPrefix prefix, int entity) {
  static final int BYTES = 16;
  static final Guid UNKNOWN = new Guid(GuidPrefix.UNKNOWN, 0);

  /**
   * The identifier that {@link #bytes} gave.
   *
   * @throws java.nio.BufferUnderflowException for less than sixteen bytes
   */
  public static Guid of(byte[] bytes) {
    return read(ByteBuffer.wrap(bytes));
  }

  /** Its sixteen bytes. */
  public byte[] bytes() {
    ByteBuffer out = ByteBuffer.allocate(BYTES);
    write(out);
    return out.array();
  }

  static Guid read(ByteBuffer in) {
    return new Guid(GuidPrefix.read(in), Wire.bigEndian(in));
  }

  void write(ByteBuffer out) {
    prefix.write(out);
    Wire.putBigEndian(out, entity);
  }

  @Override
  public String toString() {
    return String.format("%s.%08x", prefix, entity);
  }
}
