/** The one place of the simulation where the machine's clock is read. */
package org.urbi.sim.time;
