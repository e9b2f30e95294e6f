/**
 * A page for browsers that shows a simulated world while it goes on: what a camera sees, the scene
 * from above, and how the drives follow their targets. The simulation hands over what is to be
 * shown when it is asked for it, and never waits; a thread of its own does all the rest.
 */
@NullMarked
package org.urbi.sim.page;

import org.jspecify.annotations.NullMarked;
