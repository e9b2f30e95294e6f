package org.urbi.bench;

import java.util.Map;
import org.jspecify.annotations.Nullable;

/** The target of a row of the table. */
sealed interface Target {
  /** Whether the figures reach it; null when that cannot be told on this machine. */
  @Nullable Boolean met(Map<Language, Double> figures);

  /** How the table names it. */
  String text();

  /** At most so many times what another language needs. */
  record Ratio(Language to, double most) implements Target {
    @Override
    public @Nullable Boolean met(Map<Language, Double> figures) {
      Double other = figures.get(to);
      Double own = figures.get(Language.URBISCRIPT);
      return other == null || own == null ? null : own <= most * other;
    }

    @Override
    public String text() {
      return "<= %.1f x %s".formatted(most, to.label());
    }
  }

  /** At most so much, in the unit of the row. */
  record Absolute(double most, Unit unit) implements Target {
    @Override
    public @Nullable Boolean met(Map<Language, Double> figures) {
      Double own = figures.get(Language.URBISCRIPT);
      return own == null ? null : own <= most;
    }

    @Override
    public String text() {
      return "<= " + unit.text(most);
    }
  }

  /** A program must run, with the same result in every language; this one has not. */
  record Correct() implements Target {
    @Override
    public @Nullable Boolean met(Map<Language, Double> figures) {
      return false;
    }

    @Override
    public String text() {
      return "to run";
    }
  }

  /** No target: the row is for information. */
  record None() implements Target {
    @Override
    public @Nullable Boolean met(Map<Language, Double> figures) {
      return null;
    }

    @Override
    public String text() {
      return "";
    }
  }
}
