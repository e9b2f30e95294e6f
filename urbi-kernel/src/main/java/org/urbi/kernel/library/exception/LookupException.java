package org.urbi.kernel.library.exception;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.library.object.ObjectType;
import org.urbi.kernel.library.text.Spelling;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;

/** A name that was not found (manual, "Exception"). */
@UrbiType(
    value = "Exception.Lookup",
    protos = {"Exception"},
    doc = "A name that was not found.")
final class LookupException {
  private LookupException() {}

  @Builtin(doc = "Of that name, in that object; whether to look for what was meant.")
  static void init(
      UrbiObject self, UrbiObject name, UrbiObject object, @Optional UrbiObject fixSpelling) {
    if (fixSpelling != null) {
      OwnSlots.put(self, "fixSpelling", fixSpelling);
    }
    ExceptionType.set(self, "object", object);
    ExceptionType.set(self, "name", name);
  }

  @Builtin(doc = "The name that was not found, and the one which may have been meant.")
  static String asString(Frame frame, UrbiObject self) {
    String name = ExceptionType.text(frame, self, "name");
    if (name.contains("->")) {
      return "property lookup failed: " + name;
    }
    String meant = meant(frame, self, name);
    return "lookup failed: "
        + name
        + (meant == null ? "" : " (possible misspelling of " + meant + ")");
  }

  private static String meant(Frame frame, UrbiObject self, String name) {
    UrbiObject object = self.lookup(self.world().symbol("object"));
    if (object == null || !Truth.of(frame, OwnSlots.get(frame, self, "fixSpelling"))) {
      return null;
    }
    boolean local = self.lookup(self.world().symbol("local")) != null;
    Set<String> candidates = new TreeSet<>();
    for (UrbiObject holder : local ? List.of(object) : ObjectType.allProtos(object)) {
      for (Symbol slot : holder.localSlotNames()) {
        candidates.add(slot.name());
      }
    }
    return Spelling.meant(name, candidates);
  }
}
