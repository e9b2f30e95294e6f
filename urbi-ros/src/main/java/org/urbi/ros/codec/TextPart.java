package org.urbi.ros.codec;

import java.nio.charset.StandardCharsets;
import org.urbi.ros.message.FieldType;
import org.urbi.ros.message.ValueException;
import org.urbi.ros.message.Values;
import urbi.UValue;

/** A string: in UTF-8, or of wide characters. */
record TextPart(FieldType.Text type) implements Part {
  @Override
  public void write(Output out, UValue value) {
    String text = Values.text(type, value);
    if (type.wide()) {
      out.count(text.length());
      // Middleware of ROS 2 gives each of 16 bits the place of 32.
      text.chars().forEach(unit -> out.room(Integer.BYTES).putInt(unit));
      return;
    }
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    if (!out.isCdr()) {
      out.count(bytes.length);
      out.put(bytes);
      return;
    }
    if (text.indexOf('\0') >= 0) {
      throw new ValueException("strings of ROS 2 cannot contain the character 0");
    }
    out.count(bytes.length + 1);
    out.put(bytes);
    out.room(1).put((byte) 0);
  }

  @Override
  public UValue read(Input in) {
    if (type.wide()) {
      int count = in.count(Integer.BYTES);
      checkLimit(count);
      StringBuilder text = new StringBuilder(count);
      for (int i = 0; i < count; i++) {
        text.append((char) in.next(Integer.BYTES).getInt());
      }
      return new UValue(text.toString());
    }
    int count = in.count(1);
    String text = in.text(count);
    if (in.isCdr() && text.endsWith("\0")) {
      text = text.substring(0, text.length() - 1);
    }
    if (type.limit() != 0 && text.length() > type.limit()) {
      checkLimit(text.codePointCount(0, text.length()));
    }
    return new UValue(text);
  }

  /**
   * Refuses more than the type allows. Of what is not wide, characters are counted: there are nodes
   * (those in Python) that take the limit for one of characters.
   */
  private void checkLimit(int characters) {
    if (type.limit() != 0 && characters > type.limit()) {
      throw new CodecException(
          "a string of " + characters + " characters where " + type.limit() + " are allowed");
    }
  }

  @Override
  public int least() {
    return Integer.BYTES;
  }
}
