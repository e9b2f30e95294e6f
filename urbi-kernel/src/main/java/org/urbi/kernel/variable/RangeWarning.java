package org.urbi.kernel.variable;

import java.util.function.Consumer;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.object.UrbiFloat;

/**
 * Notices when the targets of a variable leave its range. They are limited in silence otherwise: a
 * motion along the limit would be a flood of warnings, so there is one each time it begins.
 */
final class RangeWarning {
  private final String name;
  private final Consumer<String> warned;
  private boolean outside;

  RangeWarning(String name, Consumer<String> warned) {
    this.name = name;
    this.warned = warned;
  }

  /** A target, and what the range has made of it. */
  void note(Datum given, Datum limited) {
    boolean before = outside;
    outside = given != limited;
    if (outside && !before) {
      double wanted = ((UrbiFloat) given.value()).value();
      double bound = ((UrbiFloat) limited.value()).value();
      warned.accept(
          Problem.LIMITED.text(
              name,
              wanted,
              wanted < bound ? "less" : "more",
              bound,
              wanted < bound ? "rangemin" : "rangemax"));
    }
  }
}
