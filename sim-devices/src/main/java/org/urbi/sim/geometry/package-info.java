/**
 * Places and shapes. Lengths are metres and angles radians; axes are those of the robotics API: x
 * to the front, y to the left, z upwards (manual, "Frame of Reference").
 *
 * <p>Sines and cosines are those of {@link StrictMath}, so that a place is the same on every
 * machine.
 */
@NullMarked
package org.urbi.sim.geometry;

import org.jspecify.annotations.NullMarked;
