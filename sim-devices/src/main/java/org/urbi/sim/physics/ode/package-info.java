/** The Open Dynamics Engine as the system has it, by native calls. */
@NullMarked
package org.urbi.sim.physics.ode;

import org.jspecify.annotations.NullMarked;
