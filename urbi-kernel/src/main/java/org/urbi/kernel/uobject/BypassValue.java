package org.urbi.kernel.uobject;

import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.variable.Datum;
import urbi.UBinary;
import urbi.UDataType;
import urbi.UValue;

/**
 * A value that Java code has written to a variable in bypass mode: those who are notified get the
 * same object.
 *
 * @param value the value, which is not copied
 */
record BypassValue(ValueConversion conversion, UValue value) implements Datum.Foreign {
  @Override
  public UrbiObject copy() {
    return conversion.toUrbi(value);
  }

  /** A copy, for later reads. */
  UValue copied() {
    return value.getType() == UDataType.DATA_BINARY
        ? new UValue(new UBinary(value.ubinaryValue()))
        : value;
  }
}
