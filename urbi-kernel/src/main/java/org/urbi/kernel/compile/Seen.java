package org.urbi.kernel.compile;

/**
 * Which of {@code return}, {@code break} and {@code continue} the code around looks at when a
 * statement is done. The others must be thrown.
 */
enum Seen {
  /** None: the statement stands in an expression. */
  NOTHING,

  /** {@code break} and {@code continue}: a loop that stands in an expression. */
  LOOPS,

  /** All of them. */
  ALL;

  /** What is seen in the body of a loop. */
  Seen inLoop() {
    return this == NOTHING ? LOOPS : this;
  }
}
