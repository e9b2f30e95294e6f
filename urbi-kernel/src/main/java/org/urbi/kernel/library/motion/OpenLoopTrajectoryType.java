package org.urbi.kernel.library.motion;

import org.urbi.builtins.UrbiType;

/**
 * Trajectories that do not look at what else happens to the variable (manual,
 * "TrajectoryGenerator").
 */
@UrbiType(
    value = "TrajectoryGenerator.OpenLoop",
    protos = {"TrajectoryGenerator"},
    doc = "Trajectories that do not look at what else happens to the variable.")
final class OpenLoopTrajectoryType {
  private OpenLoopTrajectoryType() {}
}
