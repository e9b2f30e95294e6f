package org.urbi.ros.two;

import static java.util.Objects.requireNonNull;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import org.urbi.ros.message.Values;
import urbi.UDataType;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/** What a parameter of ROS 2 can be: {@code rcl_interfaces/ParameterType}, in the same order. */
enum ParameterKind {
  NOT_SET,
  BOOL,
  INTEGER,
  DOUBLE,
  STRING,
  BYTE_ARRAY,
  BOOL_ARRAY,
  INTEGER_ARRAY,
  DOUBLE_ARRAY,
  STRING_ARRAY;

  private static final String TYPE = "type";

  /** From here on not every whole number is a number of urbiscript. */
  private static final double MOST_WHOLE = 0x1p53;

  static ParameterKind of(int number) {
    return number >= 0 && number < values().length ? values()[number] : NOT_SET;
  }

  /**
   * The one of that name.
   *
   * @throws RosException if there is none
   */
  static ParameterKind of(String name) {
    return Stream.of(values())
        .filter(each -> each != NOT_SET && each.toString().equals(name))
        .findFirst()
        .orElseThrow(() ->
            new RosException(
                "type: bool, integer, double, string, byte_array, "
                    + "bool_array, integer_array, double_array or string_array expected, not "
                    + name));
  }

  /**
   * What a value is that nobody has said anything of: a whole number is an integer.
   *
   * @throws RosException if it is nothing that a parameter can be
   */
  static ParameterKind of(UValue value) {
    return Stream.of(INTEGER, DOUBLE, STRING, BYTE_ARRAY, INTEGER_ARRAY, DOUBLE_ARRAY, STRING_ARRAY)
        .filter(each -> each.fits(value))
        .findFirst()
        .orElseThrow(() ->
            new RosException(
                "a parameter is a number, a string, a Binary, or a list"
                    + " of numbers or of strings, not "
                    + Values.shown(value)));
  }

  /** Whether a value can be this. */
  boolean fits(UValue value) {
    return switch (this) {
      case NOT_SET -> false;
      case BOOL -> isNumber(value) && (value.doubleValue() == 0 || value.doubleValue() == 1);
      case INTEGER -> isNumber(value) && isWhole(value.doubleValue());
      case DOUBLE -> isNumber(value);
      case STRING -> value.getType() == UDataType.DATA_STRING;
      case BYTE_ARRAY -> value.getType() == UDataType.DATA_BINARY;
      case BOOL_ARRAY, INTEGER_ARRAY, DOUBLE_ARRAY, STRING_ARRAY ->
          value.getType() == UDataType.DATA_LIST
              && value.ulistValue().stream().allMatch(element()::fits);
    };
  }

  private ParameterKind element() {
    return of(ordinal() - BOOL_ARRAY.ordinal() + BOOL.ordinal());
  }

  private static boolean isNumber(UValue value) {
    return value.getType() == UDataType.DATA_DOUBLE;
  }

  private static boolean isWhole(double number) {
    return number == Math.rint(number) && Math.abs(number) <= MOST_WHOLE;
  }

  /** Whether a parameter that was the one may become the other: both are numbers of urbiscript. */
  boolean mayBecome(ParameterKind other) {
    return this == other || isNumeric() && other.isNumeric() || isNumbers() && other.isNumbers();
  }

  private boolean isNumeric() {
    return List.of(INTEGER, DOUBLE).contains(this);
  }

  private boolean isNumbers() {
    return List.of(INTEGER_ARRAY, DOUBLE_ARRAY).contains(this);
  }

  private String field() {
    return this + "_value";
  }

  /** A value as {@code rcl_interfaces/ParameterValue}. */
  UDictionary message(MessageType type, UValue value) {
    UDictionary message = Templates.of(type).with(TYPE, ordinal());
    if (this != NOT_SET) message.put(field(), value);
    return message;
  }

  /** The value in such a message; an empty one if there is none. */
  static UValue value(UDictionary message) {
    ParameterKind kind = kind(message);
    if (kind == NOT_SET) return new UValue();
    return requireNonNull(message.get(kind.field()), "a decoded message has all its fields");
  }

  /** What the value in such a message is. */
  static ParameterKind kind(UDictionary message) {
    return of(GoalIds.part(message, TYPE).intValue());
  }

  /** The numbers in a value. */
  static UList numbers(UValue value) {
    return switch (value.getType()) {
      case DATA_DOUBLE -> UList.of(value);
      case DATA_LIST -> value.ulistValue();
      default -> new UList();
    };
  }

  /** Its name as people write it. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
