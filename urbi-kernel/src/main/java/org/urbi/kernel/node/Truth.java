package org.urbi.kernel.node;

import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.Values;

/** Which values are true (manual, "Truth Values"). */
public final class Truth {
  private Truth() {}

  /** Whether a value is true, by its {@code asBool}. */
  public static boolean of(Frame frame, UrbiObject value) {
    Values values = frame.interpreter.values();
    if (value == values.trueObject) {
      return true;
    }
    if (value == values.falseObject) {
      return false;
    }
    if (value instanceof UrbiFloat number && value.shape() == values.floatShape) {
      return number.value() != 0;
    }
    if (value == values.voidObject) {
      throw frame.interpreter.errors().unexpectedVoid();
    }
    return general(frame, value, values);
  }

  private static boolean general(Frame frame, UrbiObject value, Values values) {
    UrbiObject asBool = frame.interpreter.send(frame, value, "asBool");
    if (asBool == values.trueObject || asBool == values.falseObject) {
      return asBool == values.trueObject;
    }
    return of(asBool, values);
  }

  /** Whether a value is true, when nobody has redefined {@code asBool}. */
  public static boolean of(UrbiObject value, Values values) {
    if (value instanceof UrbiFloat number) {
      return number.value() != 0;
    }
    if (value instanceof UrbiString string) {
      return !string.value().isEmpty();
    }
    if (value instanceof UrbiList list) {
      return !list.elements().isEmpty();
    }
    if (value instanceof UrbiDictionary dictionary) {
      return !dictionary.entries().isEmpty();
    }
    return value != values.falseObject && value != values.nil;
  }
}
