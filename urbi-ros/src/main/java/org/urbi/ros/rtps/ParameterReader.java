package org.urbi.ros.rtps;

import java.nio.ByteBuffer;

/** Goes through a list of parameters; what follows the list is then next in the buffer. */
final class ParameterReader {
  private final ByteBuffer in;
  private int id;
  private ByteBuffer value;

  ParameterReader(ByteBuffer in) {
    this.in = in;
    this.value = in;
  }

  /** Whether there is another parameter, which {@link #id} and {@link #value} then describe. */
  boolean next() throws MalformedException {
    id = in.getShort() & 0xffff & ~ParameterId.MUST_UNDERSTAND;
    int length = in.getShort() & 0xffff;
    if (id == ParameterId.SENTINEL) return false;
    if (length > in.remaining()) throw new MalformedException("parameter longer than its message");
    value = in.slice(in.position(), length).order(in.order());
    in.position(in.position() + length);
    return true;
  }

  int id() {
    return id;
  }

  ByteBuffer value() {
    return value;
  }
}
