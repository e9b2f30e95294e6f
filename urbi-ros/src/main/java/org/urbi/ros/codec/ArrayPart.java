package org.urbi.ros.codec;

import org.urbi.ros.message.FieldType;
import org.urbi.ros.message.ValueException;
import org.urbi.ros.message.Values;
import urbi.UDataType;
import urbi.UList;
import urbi.UValue;

/** A list of the same. */
record ArrayPart(FieldType.Array type, Part element) implements Part {
  @Override
  public void write(Output out, UValue value) {
    if (value.getType() != UDataType.DATA_LIST) {
      throw new ValueException("a List expected, not " + Values.shown(value));
    }
    UList list = value.ulistValue();
    int count = list.size();
    Values.count(type, count);
    if (!isFixed()) {
      out.count(count);
    }
    for (int i = 0; i < count; i++) {
      try {
        element.write(out, list.get(i));
      } catch (ValueException e) {
        throw e.within("[" + i + "]");
      }
    }
  }

  @Override
  public UValue read(Input in) {
    int count = isFixed() ? type.size() : in.count(element.least());
    checkBound(type, count);
    UList list = new UList();
    list.getArray().ensureCapacity(count);
    for (int i = 0; i < count; i++) {
      list.getArray().add(element.read(in));
    }
    return new UValue(list);
  }

  /** Refuses more than the type allows. */
  static void checkBound(FieldType.Array type, int count) {
    if (type.length() == FieldType.Length.BOUNDED && count > type.size()) {
      throw new CodecException(count + " elements where " + type.size() + " are allowed");
    }
  }

  private boolean isFixed() {
    return type.length() == FieldType.Length.FIXED;
  }

  @Override
  public int least() {
    return isFixed() ? type.size() * element.least() : Integer.BYTES;
  }
}
