/**
 * Rigid bodies, joints and contacts. What is particular to an engine is behind {@link
 * org.urbi.sim.physics.Dynamics}, of which there are two: the Open Dynamics Engine by native calls,
 * and its translation to Java, ode4j. Everything else is here, once: mass, which pairs touch, in
 * which order contacts are taken. Both engines so compute the same thing in the same order.
 */
@NullMarked
package org.urbi.sim.physics;

import org.jspecify.annotations.NullMarked;
