package org.urbi.sim.render;

import org.jspecify.annotations.Nullable;

/**
 * How a surface looks.
 *
 * @param colour of its one half
 * @param second the colour of the other half of a checkered one; null for one of a single colour
 * @param tile the edge of a square of a checkered one, in metres
 * @param shine how strong a highlight is, from 0 to 1
 * @param glow how much of its colour it has without any light, from 0 to 1
 */
public record Appearance(
    Colour colour, @Nullable Colour second, double tile, double shine, double glow) {
  public static final Appearance PLAIN = Appearance.of(Colour.GREY);

  public static Appearance of(Colour colour) {
    return new Appearance(colour, null, 1, 0, 0);
  }

  /** A copy that glows. */
  public Appearance glowing(Colour light, double strength) {
    return new Appearance(light, null, tile, shine, strength);
  }
}
