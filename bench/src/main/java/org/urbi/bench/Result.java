package org.urbi.bench;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * A line of the table.
 *
 * @param name what {@code --only} calls it
 * @param title what was measured
 * @param figures the medians, in the unit
 * @param samples what they are the medians of; may be empty
 * @param note why something is missing, or empty
 */
record Result(
    String name,
    String title,
    Unit unit,
    Map<Language, Double> figures,
    Map<Language, List<Double>> samples,
    Target target,
    String note) {

  private static final String WRONG = "WRONG";
  private static final String MISSED = "MISSED";

  /** A row whose program is wrong: an error, not a measurement. */
  static Result failed(String name, String title, String note) {
    return new Result(name, title, Unit.TIME, Map.of(), Map.of(), new Target.Correct(), note);
  }

  /** Whether the command that measured it is to fail. */
  boolean isFailure() {
    return verdict().equals(WRONG) || unit == Unit.EXPONENT && verdict().equals(MISSED);
  }

  /** How many times what another language needs, or null. */
  @Nullable Double ratioTo(Language other) {
    Double own = figures.get(Language.URBISCRIPT);
    Double its = figures.get(other);
    return own == null || its == null || its == 0 ? null : own / its;
  }

  /** What has become of the target. */
  String verdict() {
    if (target instanceof Target.None) {
      return "";
    }
    if (target instanceof Target.Correct) {
      return WRONG;
    }
    Boolean met = target.met(figures);
    return met == null ? "unknown" : met ? "met" : MISSED;
  }
}
