package org.urbi.bench;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/** A part of the report: rows that belong together, under a heading. */
record Section(String title, List<Result> results) {

  /**
   * The same with a last row for all: the geometric mean of the ratios to each language, if any.
   */
  Section withMean(Target target) {
    Map<Language, Double> figures = new EnumMap<>(Language.class);
    for (Language language : Language.values()) {
      double[] ratios =
          results.stream()
              .map(result -> result.ratioTo(language))
              .filter(java.util.Objects::nonNull)
              .mapToDouble(Double::doubleValue)
              .toArray();
      if (ratios.length > 0) {
        double logarithms = java.util.Arrays.stream(ratios).map(Math::log).average().orElse(0);
        figures.put(language, Math.exp(-logarithms));
      }
    }
    if (figures.size() < 2) {
      return this;
    }
    List<Result> all = new ArrayList<>(results);
    all.add(new Result("mean", "geometric mean", Unit.RATIO, figures, Map.of(), target, ""));
    return new Section(title, all);
  }

  void print(PrintStream out) {
    out.println(title);
    out.println();
    new Table(results).print(out);
  }
}
