/** ode4j, the translation of the Open Dynamics Engine to Java: runs everywhere. */
@NullMarked
package org.urbi.sim.physics.ode4j;

import org.jspecify.annotations.NullMarked;
