package org.urbi.kernel.library.motion;

import org.urbi.builtins.UrbiType;

/**
 * Trajectories that start anew from the current value all the time (manual, "TrajectoryGenerator").
 */
@UrbiType(
    value = "TrajectoryGenerator.ClosedLoop",
    protos = {"TrajectoryGenerator"},
    doc = "Trajectories that start anew from the current value all the time.")
final class ClosedLoopTrajectoryType {
  private ClosedLoopTrajectoryType() {}
}
