package org.urbi.kernel.library.value;

import java.util.ArrayList;
import java.util.List;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.ParallelCalls;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;

/**
 * Calls a function on elements. It goes through a copy of them: the function may change the
 * container.
 */
public final class Iteration {
  private Iteration() {}

  /** {@code each}: one after the other; others may run in between. */
  public static void sequentially(
      Frame caller, CallSite site, UrbiObject self, List<UrbiObject> elements, UrbiObject fun) {
    for (UrbiObject element : List.copyOf(elements)) {
      caller.interpreter().call(caller, site, fun, self, element);
      caller.job().yield();
    }
  }

  /** {@code each|}: one immediately after the other. */
  public static void tightly(
      Frame caller, CallSite site, UrbiObject self, List<UrbiObject> elements, UrbiObject fun) {
    for (UrbiObject element : List.copyOf(elements)) {
      caller.job().checkInterrupted();
      caller.interpreter().call(caller, site, fun, self, element);
    }
  }

  /** {@code each&}: all at once. */
  public static void concurrently(
      Frame caller, CallSite site, UrbiObject self, List<UrbiObject> elements, UrbiObject fun) {
    ParallelCalls.forEach(
        caller,
        List.copyOf(elements),
        (frame, element) -> frame.interpreter().call(frame, site, fun, self, element));
  }

  /** {@code map}. */
  public static List<UrbiObject> map(
      Frame caller, CallSite site, UrbiObject self, List<UrbiObject> elements, UrbiObject fun) {
    List<UrbiObject> results = new ArrayList<>(elements.size());
    for (UrbiObject element : List.copyOf(elements)) {
      results.add(notVoid(caller, caller.interpreter().call(caller, site, fun, self, element)));
    }
    return results;
  }

  /** {@code filter}. */
  public static List<UrbiObject> filter(
      Frame caller, CallSite site, UrbiObject self, List<UrbiObject> elements, UrbiObject fun) {
    List<UrbiObject> results = new ArrayList<>();
    for (UrbiObject element : List.copyOf(elements)) {
      if (holds(caller, site, self, fun, element)) {
        results.add(element);
      }
    }
    return results;
  }

  /** {@code foldl}. */
  public static UrbiObject foldl(
      Frame caller,
      CallSite site,
      UrbiObject self,
      List<UrbiObject> elements,
      UrbiObject action,
      UrbiObject value) {
    UrbiObject result = value;
    for (UrbiObject element : List.copyOf(elements)) {
      result =
          notVoid(caller, caller.interpreter().call(caller, site, action, self, result, element));
    }
    return result;
  }

  /** {@code all}. */
  public static boolean all(
      Frame caller, CallSite site, UrbiObject self, List<UrbiObject> elements, UrbiObject fun) {
    for (UrbiObject element : List.copyOf(elements)) {
      if (!holds(caller, site, self, fun, element)) {
        return false;
      }
    }
    return true;
  }

  /** {@code any}. */
  public static boolean any(
      Frame caller, CallSite site, UrbiObject self, List<UrbiObject> elements, UrbiObject fun) {
    for (UrbiObject element : List.copyOf(elements)) {
      if (holds(caller, site, self, fun, element)) {
        return true;
      }
    }
    return false;
  }

  private static boolean holds(
      Frame caller, CallSite site, UrbiObject self, UrbiObject fun, UrbiObject element) {
    return Truth.of(caller, caller.interpreter().call(caller, site, fun, self, element));
  }

  /** Checks that the result of a function can be an element. */
  public static UrbiObject notVoid(Frame caller, UrbiObject result) {
    if (result == caller.interpreter().world().values().voidObject) {
      throw caller.interpreter().errors().unexpectedVoid();
    }
    return result;
  }
}
