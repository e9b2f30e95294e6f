package org.urbi.lang.highlight;

/** The kinds of pieces of a text. */
public enum Kind {
  /** What is skipped, from its first mark to its last. */
  COMMENT,
  /** Text in double quotes. */
  STRING,
  /** A number without a unit of time or of angles. */
  NUMBER,
  /** A number with a unit of time. */
  DURATION,
  /** A number with a unit of angles. */
  ANGLE,
  /** A word that means something wherever it stands, operators without a symbol among them. */
  KEYWORD,
  /** A word that means something in one place, and may be a name in others. */
  CONTEXTUAL,
  /** A word that may not be used, or that has no effect. */
  REFUSED,
  /** A name, quoted or not, with what is derived from it ({@code x'd}). */
  NAME,
  /** The data of a binary literal, and what describes them. */
  BINARY,
  /** What begins nothing. */
  INVALID,
  /** Operators, separators and brackets. */
  SYMBOL
}
