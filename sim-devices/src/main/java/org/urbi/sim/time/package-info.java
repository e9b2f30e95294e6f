/** The one place of the simulation where the machine's clock is read. */
@NullMarked
package org.urbi.sim.time;

import org.jspecify.annotations.NullMarked;
