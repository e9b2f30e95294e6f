package org.urbi.ros.rtps;

import java.nio.ByteBuffer;

/** Writes a list of parameters. */
final class ParameterWriter {
  private final ByteBuffer out;
  private int start;

  ParameterWriter(ByteBuffer out) {
    this.out = out;
  }

  /** What is put into the buffer until {@link #end} is the value. */
  ParameterWriter begin(int id) {
    out.putShort((short) id).putShort((short) 0);
    start = out.position();
    return this;
  }

  void end() {
    while ((out.position() - start) % 4 != 0) out.put((byte) 0);
    out.putShort(start - 2, (short) (out.position() - start));
  }

  void integer(int id, int value) {
    begin(id);
    out.putInt(value);
    end();
  }

  void guid(int id, Guid value) {
    begin(id);
    value.write(out);
    end();
  }

  void string(int id, String text) {
    begin(id);
    Wire.putString(out, text);
    end();
  }

  void octets(int id, byte[] bytes) {
    begin(id);
    out.putInt(bytes.length).put(bytes);
    end();
  }

  void duration(int id, long nanos) {
    begin(id);
    Wire.putDuration(out, nanos);
    end();
  }

  void finish() {
    out.putShort((short) ParameterId.SENTINEL).putShort((short) 0);
  }
}
