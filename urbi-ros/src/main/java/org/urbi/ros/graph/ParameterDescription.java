package org.urbi.ros.graph;

/**
 * What a parameter is, for those who set it.
 *
 * @param type {@code bool}, {@code integer}, {@code double}, {@code string}, {@code byte_array},
 *     {@code bool_array} …; empty for what the value is
 * @param text for people
 * @param readOnly whether other nodes may not set it
 * @param from the least number; NaN if there is no range
 * @param to the greatest number
 * @param step between one number and the next; 0 for any
 */
public record ParameterDescription(
    String type, String text, boolean readOnly, double from, double to, double step) {
  /** What is said of a parameter of which nothing is said. */
  public static final ParameterDescription NONE =
      new ParameterDescription("", "", false, Double.NaN, Double.NaN, 0);

  /** Whether numbers have a range. */
  public boolean hasRange() {
    return !Double.isNaN(from);
  }

  /** Whether the range, if there is one, has that number. */
  public boolean allows(double number) {
    if (!hasRange()) return true;
    // The end is allowed in any case, as ROS 2 has it.
    double steps = step == 0 ? 0 : (number - from) / step;
    boolean isStep = Math.abs(steps - Math.rint(steps)) < 1e-9 || number == to;
    return number >= from && number <= to && isStep;
  }
}
