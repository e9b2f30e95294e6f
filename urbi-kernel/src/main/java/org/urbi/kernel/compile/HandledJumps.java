package org.urbi.kernel.compile;

/**
 * Which of {@code return}, {@code break} and {@code continue} the surrounding code checks for after
 * a statement. The others must be thrown as exceptions.
 */
enum HandledJumps {
  /** None: the statement is part of an expression. */
  NOTHING,

  /** {@code break} and {@code continue}: a loop that is part of an expression. */
  LOOPS,

  /** All of them. */
  ALL;

  /** The jumps that are handled in the body of a loop. */
  HandledJumps inLoop() {
    return this == NOTHING ? LOOPS : this;
  }
}
