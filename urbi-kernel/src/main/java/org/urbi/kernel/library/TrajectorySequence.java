package org.urbi.kernel.library;

import org.urbi.builtins.UrbiType;

/** Motions one after the other. */
@UrbiType(
    value = "TrajectoryGenerator.Sequence",
    protos = "TrajectoryGenerator",
    doc = "A motion, and then another one.")
final class TrajectorySequence {
  /** What {@code run} does. */
  static final String RUN = "function () { first.run() | second.run() }";

  private TrajectorySequence() {}
}
