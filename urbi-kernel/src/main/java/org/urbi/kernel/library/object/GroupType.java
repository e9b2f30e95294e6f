package org.urbi.kernel.library.object;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.ParallelCalls;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Several objects as one (manual, "Group"). */
@UrbiType(
    value = "Group",
    doc = "Several objects to which messages are sent as if they were one.",
    needs = Permission.NOTHING)
final class GroupType {
  private GroupType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiGroup(world.values().object.cloneShape(), List.of());
  }

  private static Symbol symbol(UrbiObject self, String name) {
    return self.world().symbol(name);
  }

  @Builtin(doc = "Of these members.", needs = Permission.CHANGE)
  static void init(UrbiGroup self, UrbiObject... members) {
    add(self, members);
  }

  @Builtin(doc = "Adds members, and returns the target.", needs = Permission.CHANGE)
  static UrbiObject add(UrbiGroup self, UrbiObject... members) {
    for (UrbiObject member : members) {
      self.add(member);
    }
    return self;
  }

  @Builtin(
      value = {"<<"},
      doc = "Adds a member, and returns the target.",
      needs = Permission.CHANGE)
  static UrbiObject addOne(UrbiGroup self, UrbiObject member) {
    self.add(member);
    return self;
  }

  @Builtin(doc = "Removes members, and returns the target.", needs = Permission.CHANGE)
  static UrbiObject remove(Frame frame, UrbiGroup self, UrbiObject... members) {
    for (UrbiObject leaving : members) {
      self.removeIf(
          member -> Truth.of(frame, frame.interpreter().send(frame, member, "==", leaving)));
    }
    return self;
  }

  @Builtin(
      value = {"=="},
      doc = "Whether both have equal members, in the same order.")
  static boolean equal(Frame frame, UrbiGroup self, UrbiObject other) {
    if (self == other) {
      return true;
    }
    if (!(other instanceof UrbiGroup group) || group.members().size() != self.members().size()) {
      return false;
    }
    for (int i = 0; i < self.members().size(); i++) {
      UrbiObject mine = self.members().get(i);
      UrbiObject its = group.members().get(i);
      if (!Truth.of(frame, frame.interpreter().send(frame, mine, "==", its))) {
        return false;
      }
    }
    return true;
  }

  @Builtin(doc = "The members.")
  static List<UrbiObject> asList(UrbiGroup self) {
    return self.members();
  }

  @Builtin(doc = "The group as text: its members.")
  static String asString(Frame frame, UrbiGroup self) {
    if (self == self.world().prototype("Group")) {
      return "Group";
    }
    return self.members().stream()
        .map(member -> frame.interpreter().asPrintable(frame, member))
        .collect(Collectors.joining(", ", "Group [", "]"));
  }

  @Builtin(
      value = {"each"},
      doc = "Calls a function with each member, one after the other; the group of the results.")
  static UrbiObject each(Frame frame, CallSite site, UrbiGroup self, UrbiObject action) {
    List<UrbiObject> results = new ArrayList<>();
    for (UrbiObject member : self.members()) {
      results.add(frame.interpreter().call(frame, site, action, self, member));
      frame.job().yield();
    }
    return results(self, results);
  }

  @Builtin(
      value = {"each|"},
      doc = "Calls a function with each member, without letting others run.")
  static UrbiObject eachTight(Frame frame, CallSite site, UrbiGroup self, UrbiObject action) {
    List<UrbiObject> results = new ArrayList<>();
    for (UrbiObject member : self.members()) {
      results.add(frame.interpreter().call(frame, site, action, self, member));
    }
    return results(self, results);
  }

  @Builtin(
      value = {"each&"},
      doc = "Calls a function with each member, all at once; the group of the results.")
  static UrbiObject eachConcurrent(Frame frame, CallSite site, UrbiGroup self, UrbiObject action) {
    List<UrbiObject> results = new ArrayList<>();
    ParallelCalls.forEach(
        frame,
        List.copyOf(self.members()),
        (forked, member) ->
            results.add(forked.interpreter().call(forked, site, action, self, member)));
    return results(self, results);
  }

  /** Void when the members have returned void, the group of the results otherwise. */
  private static UrbiObject results(UrbiGroup self, List<UrbiObject> results) {
    UrbiObject nothing = self.world().values().voidObject;
    boolean none = !results.isEmpty() && results.stream().allMatch(r -> r == nothing);
    return none ? nothing : self.sibling(results);
  }

  @Builtin(lazy = true, doc = "Sends a message that the group does not understand to its members.")
  static UrbiObject fallback(Frame frame, CallSite site, UrbiGroup self) {
    UrbiObject[] arguments = new UrbiObject[site.argumentNodes().length];
    for (int i = 0; i < arguments.length; i++) {
      arguments[i] = site.argumentNodes()[i].execute(frame);
    }
    List<UrbiObject> results = new ArrayList<>();
    for (UrbiObject member : self.members()) {
      results.add(
          frame
              .interpreter()
              .sendOn(frame, site, member, symbol(self, site.calledName()), arguments));
    }
    return results(self, results);
  }

  @Builtin(doc = "Whether all the members have the slot.")
  static boolean hasSlot(UrbiGroup self, String name) {
    return self.members().stream().allMatch(member -> member.locate(symbol(self, name)) != null);
  }

  @Builtin(doc = "Whether the slot of each member has the property.")
  static UrbiObject hasProperty(Frame frame, UrbiGroup self, String slot, String property) {
    List<UrbiObject> results = new ArrayList<>();
    for (UrbiObject member : self.members()) {
      boolean has = ObjectSlots.hasProperty(frame, member, slot, property);
      results.add(self.world().values().bool(has));
    }
    return self.sibling(results);
  }

  @Builtin(doc = "The group of the values of a property of the slot of each member.")
  static UrbiObject getProperty(Frame frame, UrbiGroup self, String slot, String property) {
    return self.property(frame, symbol(self, slot), property);
  }

  @Builtin(doc = "Sets a property of the slot of each member.")
  static UrbiObject setProperty(
      Frame frame, UrbiGroup self, String slot, String property, UrbiObject value) {
    self.setProperty(frame, symbol(self, slot), property, value);
    return value;
  }

  @Builtin(doc = "Assigns the slot of each member; the group of what they return.")
  static UrbiObject updateSlot(Frame frame, UrbiGroup self, String name, UrbiObject value) {
    return self.updateSlot(frame, symbol(self, name), value);
  }
}
