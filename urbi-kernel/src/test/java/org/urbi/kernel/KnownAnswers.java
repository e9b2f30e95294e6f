package org.urbi.kernel;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * Which wrong calls of one builtin say nothing new, because what decides the answer has been tried
 * before:
 *
 * <ul>
 *   <li>the same call, word for word;
 *   <li>a wrong number of arguments, which is refused before any of them is looked at;
 *   <li>a value of a kind that the declaration of the builtin, not its code, has refused at the
 *       same place. Values are of one kind if they have the same Java class and the same types;
 *       objects with slots of their own are a kind each.
 * </ul>
 */
final class KnownAnswers {
  private record Refusal(int place, String kind) {}

  private final WrongValues values;
  private final Set<String> made = new HashSet<>();
  private final Set<Integer> numbers = new HashSet<>();
  private final Map<Integer, String> declared = new HashMap<>();
  private final Set<Refusal> refusals = new HashSet<>();

  KnownAnswers(WrongValues values) {
    this.values = values;
  }

  /** Whether the answer to that call is known; if it is not, the call is about to be made. */
  boolean contain(WrongCall call) {
    if (call.hasWrongArity()) {
      return !numbers.add(call.arguments().size());
    }
    return isRefused(call) || !made.add(call.source());
  }

  /** The first value that is not of the declared type decides. */
  private boolean isRefused(WrongCall call) {
    for (int place = 0; place <= call.arguments().size(); place++) {
      String type = declared.get(place);
      if (type != null && !values.isOfType(call.value(place), type)) {
        return refusals.contains(new Refusal(place, values.kind(call.value(place))));
      }
    }
    return false;
  }

  /** The declaration has refused the value at that place: it wants one of that type. */
  void refused(WrongCall call, int place, String type) {
    declared.put(place, type);
    refusals.add(new Refusal(place, values.kind(call.value(place))));
  }
}
