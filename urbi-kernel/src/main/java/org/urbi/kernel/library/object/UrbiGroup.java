package org.urbi.kernel.library.object;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Properties;
import org.urbi.kernel.node.SlotProxy;
import org.urbi.kernel.node.SlotUpdate;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;

/** Several objects to which messages are sent as if they were one (manual, "Group"). */
public final class UrbiGroup extends UrbiObject implements SlotProxy {
  private final List<UrbiObject> members = new ArrayList<>();

  UrbiGroup(Shape shape, List<UrbiObject> members) {
    super(shape);
    this.members.addAll(members);
  }

  /** A copy of the members. */
  public List<UrbiObject> members() {
    noteContentRead();
    return List.copyOf(members);
  }

  void add(UrbiObject member) {
    members.add(member);
    noteContentChange();
  }

  /** Removes what that says of the members. */
  void removeIf(Predicate<UrbiObject> leaves) {
    if (members.removeIf(leaves)) {
      noteContentChange();
    }
  }

  /** A group of the same kind, of other members. */
  public UrbiGroup sibling(List<UrbiObject> others) {
    return new UrbiGroup(world().prototype("Group").cloneShape(), others);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiGroup(cloneShape(), members);
  }

  /** A group whose members are being assigned, inside of others. */
  private record Assigned(UrbiGroup group, @Nullable Assigned outer) {
    boolean has(UrbiObject member) {
      return member == group || outer != null && outer.has(member);
    }
  }

  /** Groups of groups may have more members than anybody waits for. */
  private static void checkInterrupted(Frame frame) {
    frame.job().checkInterrupted();
  }

  /** A group of as many values is handed out, any other value goes to each member. */
  @Override
  public UrbiObject updateSlot(Frame frame, Symbol slot, UrbiObject value) {
    return updateSlot(frame, slot, value, null);
  }

  private UrbiObject updateSlot(
      Frame frame, Symbol slot, UrbiObject value, @Nullable Assigned outer) {
    Assigned assigned = new Assigned(this, outer);
    List<UrbiObject> values = new ArrayList<>();
    List<UrbiObject> targets = members();
    for (int i = 0; i < targets.size(); i++) {
      checkInterrupted(frame);
      UrbiObject target = targets.get(i);
      UrbiObject own = value;
      if (value instanceof UrbiGroup group && group.members().size() == targets.size()) {
        own = group.members().get(i);
      }
      if (assigned.has(target)) {
        // Its members are all being assigned.
        values.add(own);
      } else if (target instanceof UrbiGroup group) {
        values.add(group.updateSlot(frame, slot, own, assigned));
      } else {
        SlotUpdate.assign(frame, target, slot, own);
        values.add(own);
      }
    }
    return sibling(values);
  }

  @Override
  public UrbiObject property(Frame frame, Symbol slot, String property) {
    List<UrbiObject> values = new ArrayList<>();
    for (UrbiObject member : members()) {
      checkInterrupted(frame);
      UrbiObject value = Properties.find(frame, member, slot, property);
      if (value == null) {
        throw frame.interpreter().errors().property(member, slot.name(), property);
      }
      values.add(value);
    }
    return sibling(values);
  }

  @Override
  public void setProperty(Frame frame, Symbol slot, String property, UrbiObject value) {
    for (UrbiObject member : members()) {
      checkInterrupted(frame);
      Properties.set(frame, member, slot, property, value);
    }
  }
}
