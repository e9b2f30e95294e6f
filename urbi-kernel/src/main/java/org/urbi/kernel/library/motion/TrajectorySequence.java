package org.urbi.kernel.library.motion;

import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;

/** Motions one after the other. */
@UrbiType(
    value = "TrajectoryGenerator.Sequence",
    protos = "TrajectoryGenerator",
    doc = "A motion, and then another one.",
    needs = Permission.NOTHING)
public final class TrajectorySequence {
  /** The implementation of {@code run}. */
  public static final String RUN = "function () { first.run() | second.run() }";

  private TrajectorySequence() {}
}
