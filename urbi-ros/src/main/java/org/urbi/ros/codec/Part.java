package org.urbi.ros.codec;

import urbi.UValue;

/** What writes and reads the values of one type. */
interface Part {
  /**
   * Writes a value.
   *
   * @throws org.urbi.ros.message.ValueException if it is not of the type
   */
  void write(Output out, UValue value);

  /**
   * Reads a value.
   *
   * @throws CodecException if there is none
   */
  UValue read(Input in);

  /** How many bytes a value has at least, without what is filled in between. */
  int least();
}
