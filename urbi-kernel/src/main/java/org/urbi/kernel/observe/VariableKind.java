package org.urbi.kernel.observe;

import java.util.List;
import java.util.Map;

/** What sort of values a variable has, for those who must know before they are sent one. */
public enum VariableKind {
  NUMBER,
  BOOLEAN,
  TEXT,
  /** A list of numbers alone. */
  NUMBERS,
  LIST,
  DICTIONARY,
  /** A {@link Bytes} whose keywords say that it is a picture. */
  IMAGE,
  /** Any other {@link Bytes}, such as a sound. */
  BINARY,
  /** Values of different kinds. */
  ANY;

  /** The kind of a value that {@link SeenValue} has made. */
  static VariableKind of(Object value) {
    return switch (value) {
      case Double number -> NUMBER;
      case Boolean truth -> BOOLEAN;
      case String text -> TEXT;
      case List<?> list -> list.stream().allMatch(Double.class::isInstance) ? NUMBERS : LIST;
      case Map<?, ?> map -> DICTIONARY;
      case Bytes bytes -> bytes.isImage() ? IMAGE : BINARY;
      default -> ANY;
    };
  }

  /** The kind of a variable whose values were of this kind, and whose new value is of the other. */
  VariableKind with(VariableKind other) {
    if (this == other || this == LIST && other == NUMBERS) {
      return this;
    }
    return this == NUMBERS && other == LIST ? LIST : ANY;
  }
}
