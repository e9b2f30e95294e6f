package org.urbi.kernel.library.value;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.builtin.Primitive;
import org.urbi.kernel.job.Steps;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.Values;
import org.urbi.lang.grammar.Checkpoint;

/**
 * Compares values by the operators of urbiscript; directly, where they are plain numbers or strings
 * whose operators are those of the library.
 */
public final class Comparison {
  private Comparison() {}

  /** {@code a == b}. */
  public static boolean equal(Frame caller, UrbiObject a, UrbiObject b) {
    if (a instanceof UrbiFloat x && b instanceof UrbiFloat y && isPlain(caller, a, "==")) {
      caller.job().worked(1);
      return x.value() == y.value();
    }
    if (a instanceof UrbiString x && b instanceof UrbiString y && isPlain(caller, a, "==")) {
      return equal(caller, x.value(), y.value());
    }
    return Truth.of(caller, caller.interpreter().send(caller, a, "==", b));
  }

  private static boolean equal(Frame caller, String a, String b) {
    worked(caller, a, b);
    return a.equals(b);
  }

  /** Two texts are about to be compared. */
  private static void worked(Frame caller, String a, String b) {
    caller.job().worked(1 + Steps.ofCharacters(Math.min(a.length(), b.length())));
  }

  /** {@code a < b}. */
  public static boolean less(Frame caller, UrbiObject a, UrbiObject b) {
    if (a instanceof UrbiFloat x && b instanceof UrbiFloat y && isPlain(caller, a, "<")) {
      caller.job().worked(1);
      return x.value() < y.value();
    }
    if (a instanceof UrbiString x && b instanceof UrbiString y && isPlain(caller, a, "<")) {
      worked(caller, x.value(), y.value());
      return x.value().compareTo(y.value()) < 0;
    }
    return Truth.of(caller, caller.interpreter().send(caller, a, "<", b));
  }

  /** Whether the operator of a number or string is the one of the library. */
  public static boolean isPlain(Frame caller, UrbiObject value, String operator) {
    Values values = caller.interpreter().world().values();
    UrbiObject prototype = value instanceof UrbiFloat ? values.floatProto : values.stringProto;
    Symbol name = caller.interpreter().world().symbol(operator);
    return value.shape() == prototype.cloneShape()
        && prototype.localSlot(name) instanceof Primitive;
  }

  /** An order of values: whether the first one comes before the second one. */
  @FunctionalInterface
  public interface Order {
    boolean less(UrbiObject a, UrbiObject b);
  }

  /** The order that a function of urbiscript defines; that of {@code <} when it is null. */
  public static Order order(
      Frame caller, CallSite site, UrbiObject self, @Nullable UrbiObject function) {
    if (function == null) {
      return (a, b) -> less(caller, a, b);
    }
    return (a, b) ->
        Truth.of(caller, caller.interpreter().call(caller, site, function, self, a, b));
  }

  /** Whether a sequence of elements equals another one, two by two. */
  public static boolean equal(Frame caller, List<UrbiObject> a, List<UrbiObject> b) {
    if (a.size() != b.size()) {
      return false;
    }
    // Comparing may change them.
    List<UrbiObject> first = new ArrayList<>(a);
    List<UrbiObject> second = new ArrayList<>(b);
    for (int i = 0; i < first.size(); i++) {
      if (!equal(caller, first.get(i), second.get(i))) {
        return false;
      }
    }
    return true;
  }

  /** The lexicographic order of sequences. */
  public static boolean less(Frame caller, List<UrbiObject> a, List<UrbiObject> b) {
    List<UrbiObject> first = new ArrayList<>(a);
    List<UrbiObject> second = new ArrayList<>(b);
    int common = Math.min(first.size(), second.size());
    for (int i = 0; i < common; i++) {
      if (less(caller, first.get(i), second.get(i))) {
        return true;
      }
      if (less(caller, second.get(i), first.get(i))) {
        return false;
      }
    }
    return first.size() < second.size();
  }

  /** A sorted copy. The sort is stable, and ends with any order, even an inconsistent one. */
  public static List<UrbiObject> sorted(Frame caller, List<UrbiObject> elements, Order order) {
    Checkpoint checkpoint = new Checkpoint(caller.job()::checkInterrupted);
    UrbiObject[] from = elements.toArray(UrbiObject[]::new);
    UrbiObject[] to = new UrbiObject[from.length];
    for (int width = 1; width < from.length; width *= 2) {
      for (int start = 0; start < from.length; start += 2 * width) {
        int middle = Math.min(start + width, from.length);
        merge(from, to, start, middle, Math.min(middle + width, from.length), order, checkpoint);
      }
      UrbiObject[] swapped = from;
      from = to;
      to = swapped;
    }
    return List.of(from);
  }

  private static void merge(
      UrbiObject[] from,
      UrbiObject[] to,
      int start,
      int middle,
      int end,
      Order order,
      Checkpoint checkpoint) {
    int left = start;
    int right = middle;
    for (int i = start; i < end; i++) {
      checkpoint.pass();
      boolean takeRight = left >= middle || right < end && order.less(from[right], from[left]);
      to[i] = takeRight ? from[right++] : from[left++];
    }
  }
}
