package org.urbi.kernel.observe;

/**
 * An event as it is.
 *
 * @param number by which it is emitted
 * @param name under which it was found: a slot, or what a reaction calls it
 * @param listeners how many listen to it
 * @param times how often it was emitted
 * @param last when that was last, in nanoseconds since the start of the kernel; negative if never
 */
public record EventRow(long number, String name, int listeners, long times, long last) {}
