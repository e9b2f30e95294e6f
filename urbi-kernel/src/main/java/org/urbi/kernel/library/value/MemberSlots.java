package org.urbi.kernel.library.value;

import java.util.ArrayList;
import java.util.List;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.SlotUpdate;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Tuples whose members are slots, inherited like any others (manual, "Pair", "Triplet"). */
public final class MemberSlots {
  private MemberSlots() {}

  /** A prototype whose members are nil. */
  public static UrbiObject newPrototype(World world, String... slots) {
    UrbiObject prototype = new UrbiObject(world.values().tupleProto.cloneShape());
    for (String slot : slots) {
      prototype.addSlot(world.symbol(slot), world.values().nil);
    }
    return prototype;
  }

  /** Assigns the slots. */
  public static void set(Frame caller, UrbiObject self, String[] slots, UrbiObject... members) {
    for (int i = 0; i < slots.length; i++) {
      SlotUpdate.assign(caller, self, self.world().symbol(slots[i]), members[i]);
    }
  }

  /** The values of the slots. */
  public static List<UrbiObject> get(Frame caller, UrbiObject self, String[] slots) {
    List<UrbiObject> members = new ArrayList<>(slots.length);
    for (String slot : slots) {
      members.add(caller.interpreter().get(caller, self, self.world().symbol(slot)));
    }
    return members;
  }
}
