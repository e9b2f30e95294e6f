package org.urbi.kernel.library.collection;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.error.Errors;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.ProblemKind;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.library.value.Comparison;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;

/** The order of lists, and of their elements (manual, "List"). */
@UrbiTypePart(value = "List", needs = Permission.NOTHING)
public final class ListOrder {
  private ListOrder() {}

  @Builtin(value = "<", doc = "Whether it comes before another list in lexicographic order.")
  static boolean less(Frame caller, UrbiList self, UrbiList other) {
    return Comparison.less(caller, self.elements(), other.elements());
  }

  @Builtin(doc = "A new list with the elements in the order that fun, or '<', says.")
  static List<UrbiObject> sort(
      Frame caller, CallSite site, UrbiList self, @Optional @Nullable UrbiObject fun) {
    Comparison.Order order = Comparison.order(caller, site, self, fun);
    try {
      return Comparison.sorted(caller, self.elements(), order);
    } catch (UrbiException e) {
      throw fun == null ? incomparable(caller, site, 1, e) : e;
    }
  }

  @Builtin(doc = "The greatest element, as fun, or '<', says.")
  static UrbiObject max(
      Frame caller, CallSite site, UrbiList self, @Optional @Nullable UrbiObject fun) {
    return max(caller, site, self.elements(), self, fun);
  }

  @Builtin(doc = "The least element, as fun, or '<', says.")
  static UrbiObject min(
      Frame caller, CallSite site, UrbiList self, @Optional @Nullable UrbiObject fun) {
    return min(caller, site, self.elements(), self, fun);
  }

  @Builtin(doc = "The index of the first of the greatest elements, as fun, or '<', says.")
  static int argMax(
      Frame caller, CallSite site, UrbiList self, @Optional @Nullable UrbiObject fun) {
    return best(caller, site, new ArrayList<>(self.elements()), self, fun, false);
  }

  @Builtin(doc = "The index of the first of the least elements, as fun, or '<', says.")
  static int argMin(
      Frame caller, CallSite site, UrbiList self, @Optional @Nullable UrbiObject fun) {
    return best(caller, site, new ArrayList<>(self.elements()), self, fun, true);
  }

  /**
   * The greatest of some values.
   *
   * @param fun the order; {@code <} when it is null
   */
  public static UrbiObject max(
      Frame caller,
      CallSite site,
      List<UrbiObject> values,
      UrbiObject self,
      @Nullable UrbiObject fun) {
    List<UrbiObject> copy = List.copyOf(values);
    return copy.get(best(caller, site, copy, self, fun, false));
  }

  /**
   * The least of some values.
   *
   * @param fun the order; {@code <} when it is null
   */
  public static UrbiObject min(
      Frame caller,
      CallSite site,
      List<UrbiObject> values,
      UrbiObject self,
      @Nullable UrbiObject fun) {
    List<UrbiObject> copy = List.copyOf(values);
    return copy.get(best(caller, site, copy, self, fun, true));
  }

  private static int best(
      Frame caller,
      CallSite site,
      List<UrbiObject> values,
      UrbiObject self,
      @Nullable UrbiObject fun,
      boolean least) {
    if (values.isEmpty()) {
      throw caller.error(site, Problem.NOTHING_TO_COMPARE);
    }
    Comparison.Order order = Comparison.order(caller, site, self, fun);
    int best = 0;
    for (int i = 1; i < values.size(); i++) {
      try {
        if (least
            ? order.less(values.get(i), values.get(best))
            : order.less(values.get(best), values.get(i))) {
          best = i;
        }
      } catch (UrbiException e) {
        throw fun == null ? incomparable(caller, site, i, e) : e;
      }
    }
    return best;
  }

  /** An error in the argument of the comparison is an error in an element of the list. */
  private static UrbiException incomparable(
      Frame caller, CallSite site, int index, UrbiException thrown) {
    Errors errors = caller.interpreter().errors();
    if (!errors.is(thrown.value(), ProblemKind.ARGUMENT)) {
      return thrown;
    }
    UrbiObject cause = thrown.value().lookup(caller.interpreter().world().symbol("exception"));
    return cause == null ? thrown : errors.argument(site.calledName(), index, cause);
  }
}
