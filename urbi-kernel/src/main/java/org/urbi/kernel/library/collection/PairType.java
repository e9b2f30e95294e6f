package org.urbi.kernel.library.collection;

import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.library.value.Counting;
import org.urbi.kernel.library.value.MemberSlots;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Tuples of two objects, which are slots (manual, "Pair"). */
@UrbiType(
    value = "Pair",
    protos = "Tuple",
    doc = "A tuple of two objects: its slots first, second.",
    needs = Permission.NOTHING)
final class PairType {
  private static final String[] SLOTS = {"first", "second"};

  private PairType() {}

  static UrbiObject newPrototype(World world) {
    return MemberSlots.newPrototype(world, SLOTS);
  }

  @Builtin(doc = "Makes the arguments the members.", needs = Permission.CHANGE)
  static UrbiObject init(Frame caller, UrbiObject self, UrbiObject first, UrbiObject second) {
    MemberSlots.set(caller, self, SLOTS, first, second);
    return self;
  }

  @Builtin(doc = "The list of the members.")
  static List<UrbiObject> members(Frame caller, UrbiObject self) {
    return MemberSlots.get(caller, self, SLOTS);
  }

  @Builtin(
      value = "[]=",
      doc = "Replaces the member at an index; returns the value.",
      needs = Permission.CHANGE)
  static UrbiObject setAt(
      Frame caller, CallSite site, UrbiObject self, UrbiFloat index, UrbiObject value) {
    String slot = SLOTS[Counting.index(caller, site, index, SLOTS.length)];
    MemberSlots.set(caller, self, new String[] {slot}, value);
    return value;
  }
}
