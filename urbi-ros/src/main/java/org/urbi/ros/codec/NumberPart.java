package org.urbi.ros.codec;

import java.nio.ByteBuffer;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.Primitive;
import org.urbi.ros.message.Values;
import urbi.UValue;

/** A number, or a Boolean: 0 or 1. */
record NumberPart(Primitive primitive, Dialect dialect) implements Part {
  private static final double TWO_TO_64 = 0x1p64;

  @Override
  public void write(Output out, UValue value) {
    double number = Values.number(primitive, value);
    ByteBuffer buffer = out.room(primitive.size());
    switch (primitive) {
      case FLOAT32 -> buffer.putFloat((float) number);
      case FLOAT64 -> buffer.putDouble(number);
      default -> {
        long bits = Values.bits(primitive, number);
        switch (primitive.size()) {
          case Byte.BYTES -> buffer.put((byte) bits);
          case Short.BYTES -> buffer.putShort((short) bits);
          case Integer.BYTES -> buffer.putInt((int) bits);
          default -> buffer.putLong(bits);
        }
      }
    }
  }

  @Override
  public UValue read(Input in) {
    ByteBuffer buffer = in.next(primitive.size());
    return new UValue(
        switch (primitive) {
          case BOOL -> buffer.get() == 0 ? 0.0 : 1.0;
          case BYTE -> dialect == Dialect.ROS_1 ? buffer.get() : buffer.get() & 0xFF;
          case INT8 -> buffer.get();
          case CHAR, UINT8 -> buffer.get() & 0xFF;
          case INT16 -> buffer.getShort();
          case UINT16 -> buffer.getShort() & 0xFFFF;
          case INT32 -> buffer.getInt();
          case UINT32 -> buffer.getInt() & 0xFFFF_FFFFL;
          case INT64 -> buffer.getLong();
          case UINT64 -> unsigned(buffer.getLong());
          case FLOAT32 -> buffer.getFloat();
          case FLOAT64 -> buffer.getDouble();
          case TIME, DURATION -> throw new AssertionError(primitive);
        });
  }

  private static double unsigned(long bits) {
    return bits >= 0 ? bits : bits + TWO_TO_64;
  }

  @Override
  public int least() {
    return primitive.size();
  }
}
