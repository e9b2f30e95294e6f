package org.urbi.kernel.observe;

import java.util.List;

/**
 * Values of slots at one time.
 *
 * @param time in nanoseconds since the start of the kernel
 * @param values in the order of the ways to the slots; NaN for a slot that is missing or has no
 *     number
 */
public record Sample(long time, List<Double> values) {
  /** The values of how many slots can be had at a time. */
  public static final int MOST = 16;
}
