/**
 * A simulated robot: worlds of rigid bodies, cameras that look at them, image processing, and the
 * devices that urbiscript sees of all that.
 */
@NullMarked
package org.urbi.sim;

import org.jspecify.annotations.NullMarked;
