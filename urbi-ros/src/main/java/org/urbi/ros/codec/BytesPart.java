package org.urbi.ros.codec;

import org.urbi.ros.message.FieldType;
import org.urbi.ros.message.Primitive;
import org.urbi.ros.message.ValueException;
import org.urbi.ros.message.Values;
import urbi.UBinary;
import urbi.UDataType;
import urbi.UList;
import urbi.UValue;

/** Bytes: a Binary. A list of numbers is taken as well. */
record BytesPart(FieldType.Array type) implements Part {
  @Override
  public void write(Output out, UValue value) {
    byte[] bytes = bytes(value);
    Values.count(type, bytes.length);
    if (!isFixed()) {
      out.count(bytes.length);
    }
    out.put(bytes);
  }

  private static byte[] bytes(UValue value) {
    if (value.getType() == UDataType.DATA_BINARY) {
      return value.ubinaryValue().getData();
    }
    if (value.getType() != UDataType.DATA_LIST) {
      throw new ValueException("a Binary expected, not " + Values.shown(value));
    }
    UList list = value.ulistValue();
    byte[] bytes = new byte[list.size()];
    for (int i = 0; i < bytes.length; i++) {
      try {
        bytes[i] = (byte) Values.number(Primitive.UINT8, list.get(i));
      } catch (ValueException e) {
        throw e.within("[" + i + "]");
      }
    }
    return bytes;
  }

  @Override
  public UValue read(Input in) {
    int count = isFixed() ? type.size() : in.count(1);
    ArrayPart.checkBound(type, count);
    return new UValue(new UBinary(in.bytes(count)));
  }

  private boolean isFixed() {
    return type.length() == FieldType.Length.FIXED;
  }

  @Override
  public int least() {
    return isFixed() ? type.size() : Integer.BYTES;
  }
}
