/** Variables that move along trajectories (manual, "TrajectoryGenerator"). */
package org.urbi.kernel.library.motion;
