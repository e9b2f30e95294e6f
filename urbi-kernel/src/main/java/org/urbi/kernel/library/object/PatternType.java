package org.urbi.kernel.library.object;

import java.util.Map;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;

/** Objects that values are matched against (manual, "Pattern"). */
@UrbiType(
    value = "Pattern",
    doc = "What values are matched against, and what they have bound.",
    needs = Permission.NOTHING)
final class PatternType {
  private static final String PATTERN = "pattern";

  /** The slot with the values that bindings have got. */
  static final String BINDINGS = "bindings";

  private static final String MATCH = "match";
  private static final String MATCH_AGAINST = "matchAgainst";

  private PatternType() {}

  @Builtin(
      doc = "Matches values against that one, parts of which may be bindings.",
      needs = Permission.CHANGE)
  static UrbiObject init(UrbiObject self, UrbiObject pattern) {
    OwnSlots.put(self, PATTERN, pattern);
    forget(self);
    return self;
  }

  private static void forget(UrbiObject self) {
    OwnSlots.put(self, BINDINGS, self.world().values().dictionary(Map.of()));
  }

  @Builtin(doc = "The object that values are matched against.")
  static UrbiObject pattern(UrbiObject self) {
    return self.world().values().nil;
  }

  @Builtin(doc = "The values that the last match has bound, by name.")
  static UrbiObject bindings(UrbiObject self) {
    return self.world().values().dictionary(Map.of());
  }

  @Builtin(
      doc = "Whether a value matches; bindings has then what it has bound.",
      needs = Permission.CHANGE)
  static boolean match(Frame frame, UrbiObject self, UrbiObject value) {
    forget(self);
    return matchPattern(frame, self, OwnSlots.get(frame, self, PATTERN), value);
  }

  @Builtin(doc = "Whether a value matches a part of the pattern, as one of the two says.")
  static boolean matchPattern(Frame frame, UrbiObject self, UrbiObject pattern, UrbiObject value) {
    if (matchesParts(pattern)) {
      return Truth.of(frame, frame.interpreter().send(frame, pattern, MATCH, self, value));
    }
    if (value.lookup(self.world().symbol(MATCH_AGAINST)) != null) {
      return Truth.of(frame, frame.interpreter().send(frame, value, MATCH_AGAINST, self, pattern));
    }
    return Truth.of(frame, frame.interpreter().send(frame, pattern, "==", value));
  }

  /** Whether it is a pattern by itself; what {@code Regexp} matches with is something else. */
  private static boolean matchesParts(UrbiObject pattern) {
    UrbiObject owner = pattern.locate(pattern.world().symbol(MATCH));
    return owner != null
        && owner != pattern.world().prototype("Regexp")
        && owner != pattern.world().prototype("Pattern");
  }
}
