package org.urbi.sim.render;

/** Red, green and blue, each usually between 0 and 1. */
public record Colour(double red, double green, double blue) {
  public static final Colour BLACK = new Colour(0, 0, 0);
  public static final Colour WHITE = new Colour(1, 1, 1);
  public static final Colour GREY = new Colour(0.7, 0.7, 0.7);

  public Colour times(double factor) {
    return new Colour(red * factor, green * factor, blue * factor);
  }
}
