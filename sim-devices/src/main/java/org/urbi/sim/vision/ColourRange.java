package org.urbi.sim.vision;

import org.urbi.sim.SimulationException;

/**
 * Colours that are alike: hue in degrees, saturation and value from 0 to 1. A range of hues may go
 * through 0: from 350 to 10 are reds.
 */
public record ColourRange(
    double minHue,
    double maxHue,
    double minSaturation,
    double maxSaturation,
    double minValue,
    double maxValue) {
  /** Strong reds. */
  public static final ColourRange RED = new ColourRange(345, 15, 0.5, 1, 0.2, 1);

  public ColourRange {
    check("hue", minHue, maxHue, 360, false);
    check("saturation", minSaturation, maxSaturation, 1, true);
    check("value", minValue, maxValue, 1, true);
  }

  private static void check(String what, double low, double high, double most, boolean ordered) {
    if (!(low >= 0 && low <= most && high >= 0 && high <= most) || ordered && low > high) {
      throw new SimulationException(
          what + ": a range between 0 and " + (int) most + " expected, not " + low + " to " + high);
    }
  }
}
