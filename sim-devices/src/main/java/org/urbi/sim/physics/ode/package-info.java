/** The Open Dynamics Engine as the system has it, by native calls. */
package org.urbi.sim.physics.ode;
