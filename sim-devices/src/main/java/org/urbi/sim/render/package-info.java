/**
 * Pictures of a scene, with a depth buffer and no graphics hardware. Only additions,
 * multiplications, divisions and square roots go into a pixel: it is the same on every machine.
 */
@NullMarked
package org.urbi.sim.render;

import org.jspecify.annotations.NullMarked;
