package org.urbi.ros.codec;

import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.Primitive;
import org.urbi.ros.message.Templates;
import org.urbi.ros.message.ValueException;
import org.urbi.ros.message.Values;
import urbi.UDataType;
import urbi.UDictionary;
import urbi.UValue;

/** A time or a duration of ROS 1: seconds and nanoseconds. */
record InstantPart(NumberPart number) implements Part {
  static InstantPart of(Primitive instant) {
    return new InstantPart(
        new NumberPart(
            instant == Primitive.TIME ? Primitive.UINT32 : Primitive.INT32, Dialect.ROS_1));
  }

  @Override
  public void write(Output out, UValue value) {
    if (value.getType() != UDataType.DATA_DICTIONARY) {
      throw new ValueException(
          "a Dictionary of sec and nanosec expected, not " + Values.shown(value));
    }
    UDictionary time = value.udictionaryValue();
    write(out, time, Templates.SECONDS);
    write(out, time, Templates.NANOSECONDS);
    if (time.size() != 2) {
      throw new ValueException("a time has no other keys than sec and nanosec: " + time.keySet());
    }
  }

  private void write(Output out, UDictionary time, String key) {
    UValue value = time.get(key);
    if (value == null) {
      throw new ValueException("this key is missing").within(key);
    }
    try {
      number.write(out, value);
    } catch (ValueException e) {
      throw e.within(key);
    }
  }

  @Override
  public UValue read(Input in) {
    double seconds = number.read(in).doubleValue();
    return Templates.instant(seconds, number.read(in).doubleValue());
  }

  @Override
  public int least() {
    return 2 * number.least();
  }
}
