package org.urbi.ros.uobject;

import java.util.Map;
import org.urbi.ros.graph.ParameterDescription;
import org.urbi.ros.graph.RosException;
import urbi.UDataType;
import urbi.UDictionary;
import urbi.UValue;

/** What urbiscript says of a parameter. */
final class ParameterKeys {
  private ParameterKeys() {}

  /**
   * What is said.
   *
   * @param keys {@code type}, {@code description}, {@code readOnly}, {@code from} and {@code to},
   *     {@code step}; any of them may be missing, but not one of the two
   * @throws RosException if there is another key, or a value that it cannot have
   */
  static ParameterDescription of(UDictionary keys) {
    String type = "";
    String text = "";
    boolean readOnly = false;
    double from = Double.NaN;
    double to = Double.NaN;
    double step = 0;
    for (Map.Entry<String, UValue> each : keys.entrySet()) {
      String key = each.getKey();
      UValue value = each.getValue();
      switch (key) {
        case "type" -> type = text(key, value);
        case "description" -> text = text(key, value);
        case "readOnly" -> readOnly = number(key, value) != 0;
        case "from" -> from = number(key, value);
        case "to" -> to = number(key, value);
        case "step" -> step = number(key, value);
        default ->
            throw new RosException(
                "type, description, readOnly, from, to or step expected, not '" + key + "'");
      }
    }
    if (!Double.isNaN(from) != from <= to || Double.isNaN(from) != Double.isNaN(to) || step < 0) {
      throw new RosException("from and to expected, the smaller number first, and no step below 0");
    }
    return new ParameterDescription(type, text, readOnly, from, to, step);
  }

  private static String text(String key, UValue value) {
    if (value.getType() != UDataType.DATA_STRING) {
      throw new RosException(key + ": a string expected");
    }
    return value.stringValue();
  }

  private static double number(String key, UValue value) {
    if (value.getType() != UDataType.DATA_DOUBLE) {
      throw new RosException(key + ": a number expected");
    }
    return value.doubleValue();
  }
}
