/**
 * Worlds as they are written down: the file format, and what it describes brought to life. A file
 * is read whole, or refused whole with the place of the first mistake.
 */
@NullMarked
package org.urbi.sim.world;

import org.jspecify.annotations.NullMarked;
