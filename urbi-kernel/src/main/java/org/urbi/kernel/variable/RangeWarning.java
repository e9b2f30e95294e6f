package org.urbi.kernel.variable;

import java.util.function.Consumer;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.object.UrbiFloat;

/**
 * Warns when the targets of a variable leave its range. To avoid a flood of warnings, there is only
 * one until they are inside again; in between, targets are limited silently.
 */
final class RangeWarning {
  private final String name;
  private final Consumer<String> warned;
  private boolean outside;

  RangeWarning(String name, Consumer<String> warned) {
    this.name = name;
    this.warned = warned;
  }

  /** Compares a target with the value limited to the range. */
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
