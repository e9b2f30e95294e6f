package org.urbi.kernel.library.collection;

import java.util.ArrayList;
import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.value.Comparison;
import org.urbi.kernel.library.value.Iteration;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;

/** Searching lists, and calling functions on each element (manual, "List"). */
@UrbiTypePart(value = "List", needs = Permission.NOTHING)
final class ListSearch {
  private ListSearch() {}

  // ------------------------------------------------------------------ members

  @Builtin(doc = "Whether an element is equal to that.")
  static boolean has(Frame caller, UrbiList self, UrbiObject that) {
    List<UrbiObject> elements = List.copyOf(self.elements());
    caller.job().worked(elements.size());
    for (UrbiObject element : elements) {
      if (Comparison.equal(caller, element, that)) {
        return true;
      }
    }
    return false;
  }

  @Builtin(doc = "Whether an element is that very object.")
  static boolean hasSame(Frame caller, UrbiList self, UrbiObject that) {
    for (UrbiObject element : self.elements()) {
      caller.job().worked(1);
      if (element == that) {
        return true;
      }
    }
    return false;
  }

  @Builtin(doc = "Whether all elements are elements of that list.")
  static boolean subset(Frame caller, UrbiList self, UrbiList that) {
    for (UrbiObject element : List.copyOf(self.elements())) {
      if (!has(caller, that, element)) {
        return false;
      }
    }
    return true;
  }

  @Builtin(value = "==", doc = "Whether that is a list with equal elements.")
  static boolean equals(Frame caller, UrbiList self, UrbiObject that) {
    return that instanceof UrbiList other
        && (self == other || Comparison.equal(caller, self.elements(), other.elements()));
  }

  @Builtin(doc = "Whether the elements match those of a pattern, by the match of handler.")
  static boolean matchAgainst(Frame caller, UrbiList self, UrbiObject handler, UrbiObject pattern) {
    return pattern instanceof UrbiList other
        && matchAll(caller, self.elements(), handler, other.elements());
  }

  /** Whether two sequences match element by element. */
  static boolean matchAll(
      Frame caller, List<UrbiObject> elements, UrbiObject handler, List<UrbiObject> patterns) {
    if (elements.size() != patterns.size()) {
      return false;
    }
    List<UrbiObject> matched = List.copyOf(elements);
    List<UrbiObject> by = List.copyOf(patterns);
    for (int i = 0; i < matched.size(); i++) {
      if (!matches(caller, handler, by.get(i), matched.get(i))) {
        return false;
      }
    }
    return true;
  }

  /** Whether the handler of a match, a {@code Pattern}, says that a value matches a pattern. */
  static boolean matches(Frame caller, UrbiObject handler, UrbiObject pattern, UrbiObject value) {
    return Truth.of(
        caller, caller.interpreter().send(caller, handler, "matchPattern", pattern, value));
  }

  // ------------------------------------------------------------------ functions of elements

  @Builtin(doc = "Calls fun with each element, one after the other.")
  static void each(Frame caller, CallSite site, UrbiList self, UrbiObject fun) {
    Iteration.sequentially(caller, site, self, self.elements(), fun);
  }

  @Builtin(value = "each|", doc = "Calls fun with each element, without letting others run.")
  static void eachTight(Frame caller, CallSite site, UrbiList self, UrbiObject fun) {
    Iteration.tightly(caller, site, self, self.elements(), fun);
  }

  @Builtin(value = "each&", doc = "Calls fun with each element, all at once.")
  static void eachConcurrent(Frame caller, CallSite site, UrbiList self, UrbiObject fun) {
    Iteration.concurrently(caller, site, self, self.elements(), fun);
  }

  @Builtin(doc = "Calls fun with each element and its index, one after the other.")
  static void eachi(Frame caller, CallSite site, UrbiList self, UrbiObject fun) {
    int index = 0;
    for (UrbiObject element : List.copyOf(self.elements())) {
      caller
          .interpreter()
          .call(caller, site, fun, self, element, caller.interpreter().values().number(index++));
      caller.job().yield();
    }
  }

  @Builtin(doc = "The results of fun for each element.")
  static List<UrbiObject> map(Frame caller, CallSite site, UrbiList self, UrbiObject fun) {
    return Iteration.map(caller, site, self, self.elements(), fun);
  }

  @Builtin(doc = "The elements for which fun is true.")
  static List<UrbiObject> filter(Frame caller, CallSite site, UrbiList self, UrbiObject fun) {
    return Iteration.filter(caller, site, self, self.elements(), fun);
  }

  @Builtin(doc = "From value on, the result of action for the result so far and the next element.")
  static UrbiObject foldl(
      Frame caller, CallSite site, UrbiList self, UrbiObject action, UrbiObject value) {
    return Iteration.foldl(caller, site, self, self.elements(), action, value);
  }

  @Builtin(doc = "Whether fun is true for all elements.")
  static boolean all(Frame caller, CallSite site, UrbiList self, UrbiObject fun) {
    return Iteration.all(caller, site, self, self.elements(), fun);
  }

  @Builtin(doc = "Whether fun is true for an element.")
  static boolean any(Frame caller, CallSite site, UrbiList self, UrbiObject fun) {
    return Iteration.any(caller, site, self, self.elements(), fun);
  }

  @Builtin(doc = "The results of fun for the elements of both lists, two by two.")
  static List<UrbiObject> zip(
      Frame caller, CallSite site, UrbiList self, UrbiObject fun, UrbiList other) {
    List<UrbiObject> first = List.copyOf(self.elements());
    List<UrbiObject> second = List.copyOf(other.elements());
    if (first.size() != second.size()) {
      throw caller.error(site, Problem.LISTS_OF_SIZES);
    }
    List<UrbiObject> results = new ArrayList<>(first.size());
    for (int i = 0; i < first.size(); i++) {
      UrbiObject result =
          caller.interpreter().call(caller, site, fun, self, first.get(i), second.get(i));
      results.add(Iteration.notVoid(caller, result));
    }
    return results;
  }
}
