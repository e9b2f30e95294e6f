/**
 * What urbiscript sees of a simulated world: UObjects, with the slots of the robotics API (manual,
 * "Gostai Standard Robotics API"). They run plugged and remote.
 */
@NullMarked
package org.urbi.sim.device;

import org.jspecify.annotations.NullMarked;
