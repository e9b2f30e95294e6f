package org.urbi.sim.world;

import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** The units of a number in a world file; the first one may be omitted. */
enum Unit {
  NONE,
  LENGTH("m", 1, "cm", 0.01, "mm", 0.001),
  ANGLE("rad", 1, "deg", Math.PI / 180),
  TIME("s", 1, "ms", 0.001),
  MASS("kg", 1, "g", 0.001);

  private final Map<String, Double> factors = new LinkedHashMap<>();

  Unit(Object... namesAndFactors) {
    for (int i = 0; i < namesAndFactors.length; i += 2) {
      factors.put((String) namesAndFactors[i], ((Number) namesAndFactors[i + 1]).doubleValue());
    }
  }

  /** How many of the base unit it is, or null. */
  @Nullable Double factor(String name) {
    return factors.get(name);
  }

  /** As a message lists them. */
  String names() {
    return String.join(" or ", factors.keySet());
  }
}
