/** Variables that move along trajectories (manual, "TrajectoryGenerator"). */
@NullMarked
package org.urbi.kernel.library.motion;

import org.jspecify.annotations.NullMarked;
