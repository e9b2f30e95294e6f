/**
 * What urbiscript sees of a simulated world: UObjects, with the slots of the robotics API (manual,
 * "Gostai Standard Robotics API"). They run plugged and remote.
 */
package org.urbi.sim.device;
