/** ode4j, the translation of the Open Dynamics Engine to Java: runs everywhere. */
package org.urbi.sim.physics.ode4j;
