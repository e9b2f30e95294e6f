package org.urbi.kernel.uobject;

import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.variable.Datum;
import urbi.UBinary;
import urbi.UDataType;
import urbi.UValue;

/**
 * What Java code has written to a variable in bypass mode: whoever is notified of it gets the same
 * object.
 *
 * @param value which is not copied
 */
record BypassValue(ValueConversion conversion, UValue value) implements Datum.Foreign {
  @Override
  public UrbiObject copy() {
    return conversion.toUrbi(value);
  }

  /** A copy for those who look at it later. */
  UValue copied() {
    return value.getType() == UDataType.DATA_BINARY
        ? new UValue(new UBinary(value.ubinaryValue()))
        : value;
  }
}
