package org.urbi.kernel.external;

import java.util.Iterator;
import java.util.Map;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.lang.print.StringEscape;
import urbi.UBinary;
import urbi.UValue;

/** Writes values in the text form that clients of Urbi 2.7 read; each {@code char} is a byte. */
public final class ValueText {
  /** Integers up to this value are written without an exponent. */
  private static final double LONGEST_WHOLE = 1e15;

  private ValueText() {}

  /** The text of a value. */
  public static String of(UValue value) {
    StringBuilder text = new StringBuilder();
    append(text, value);
    return text.toString();
  }

  static void append(StringBuilder to, UValue value) {
    switch (value.getType()) {
      case DATA_VOID -> to.append("nil");
      case DATA_DOUBLE -> to.append(number(value.doubleValue()));
      case DATA_STRING, DATA_SLOTNAME -> quote(to, value.stringValue());
      case DATA_BINARY -> binary(to, value.ubinaryValue());
      case DATA_LIST -> {
        to.append('[');
        Iterator<UValue> elements = value.ulistValue().iterator();
        while (elements.hasNext()) {
          append(to, elements.next());
          to.append(elements.hasNext() ? ", " : "");
        }
        to.append(']');
      }
      case DATA_DICTIONARY -> {
        Iterator<Map.Entry<String, UValue>> entries =
            value.udictionaryValue().entrySet().iterator();
        to.append(entries.hasNext() ? "[" : "[ => ");
        while (entries.hasNext()) {
          Map.Entry<String, UValue> entry = entries.next();
          quote(to, entry.getKey());
          append(to.append(" => "), entry.getValue());
          to.append(entries.hasNext() ? ", " : "");
        }
        to.append(']');
      }
    }
  }

  private static String number(double value) {
    if (Double.isInfinite(value)) {
      return value > 0 ? "inf" : "-inf";
    }
    if (Double.isNaN(value)) {
      return "nan";
    }
    boolean whole = value == Math.rint(value) && Math.abs(value) < LONGEST_WHOLE;
    return whole ? Long.toString((long) value) : Double.toString(value);
  }

  /** Writes a string in quotes; characters that are not printable ASCII are escaped. */
  static void quote(StringBuilder to, String text) {
    to.append('"');
    String bytes = Utf8Text.fromComponent(text);
    for (int i = 0; i < bytes.length(); i++) {
      StringEscape.appendBasic(to, bytes.charAt(i), '"');
    }
    to.append('"');
  }

  private static void binary(StringBuilder to, UBinary binary) {
    byte[] data = binary.getData();
    String keywords = binary.getMessage();
    to.append("BIN ").append(data.length);
    if (!keywords.isEmpty()) {
      to.append(' ');
      to.append(Utf8Text.toUrbi(keywords));
    }
    to.append('\n').append(Utf8Text.text(data));
  }
}
