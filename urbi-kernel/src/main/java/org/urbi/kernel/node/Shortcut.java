package org.urbi.kernel.node;

/** Functions of the library that compiled code does by itself. */
public enum Shortcut {
  /** {@code list[i]}. */
  ELEMENT,
  /** {@code list[i] = value}. */
  SET_ELEMENT,
  /** {@code list << value}. */
  APPEND,
  /** {@code list.size}. */
  SIZE_OF_LIST,
  /** {@code text.size}. */
  SIZE_OF_TEXT,
  /** {@code dictionary.size}. */
  SIZE_OF_DICTIONARY,
  /** {@code !condition}, of a truth value. */
  NOT,
  /** {@code dictionary[key]}. */
  ENTRY,
  /** {@code dictionary[key] = value}. */
  SET_ENTRY,
  /** {@code dictionary.has(key)}. */
  HAS_ENTRY
}
