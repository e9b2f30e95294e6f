package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiCode;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/**
 * Where compiled code expects a slot: a constant of it, whose parts a JIT trusts since it is a
 * record.
 *
 * @param epoch that of the name; when it changes, the slot may be elsewhere
 * @param shape the shape of the target; null if it is one object
 * @param self that object
 * @param holder whose slot it is; null if the target itself has it
 * @param index the index among the slots of its holder
 * @param own the code there, for all that is known, if it is a slot of the target itself; or null
 */
public record KnownSlot(
    World world,
    Symbol name,
    int epoch,
    @Nullable Shape shape,
    @Nullable UrbiObject self,
    @Nullable UrbiObject holder,
    int index,
    SlotLookup.@Nullable OwnCode own) {

  private boolean isExpected(UrbiObject target) {
    return shape == null ? target == self : target.shape() == shape;
  }

  /** Whether the slot of that target is here, and nobody collects what is read. */
  public boolean isOf(UrbiObject target) {
    return isExpected(target) && name.epoch() == epoch && world.tracker == null;
  }

  /** The value of the slot, if it is {@linkplain #isOf here}. */
  public UrbiObject read(UrbiObject target) {
    return (holder == null ? target : holder).slotAt(index);
  }

  /** The value of the slot if it is here, and no code; otherwise null. */
  public @Nullable UrbiObject plainValue(UrbiObject target) {
    if (isOf(target)) {
      UrbiObject value = read(target);
      return value instanceof UrbiCode ? null : value;
    }
    return null;
  }

  /** Whether it is a slot of the target itself, told by its shape alone. */
  public @Nullable Shape ownShape() {
    return holder == null ? shape : null;
  }

  /** Whether the slot may have a number, for all that is known. */
  public boolean mayBeNumber() {
    return holder == null || holder.slotAt(index) instanceof UrbiFloat;
  }

  /** Sets the slot, if it is here; returns whether it has done so. */
  public boolean set(UrbiObject target, UrbiObject value, Job job) {
    if (isExpected(target) && (shape != null || name.epoch() == epoch) && job.isOwner()) {
      target.setSlotAt(index, value);
      return true;
    }
    return false;
  }

  /** Whether the slot is one of the target itself, and is just set. */
  public boolean isPlainlyOwn() {
    return self != null && holder == self && !self.shape().writeSpecial(index);
  }

  /** The code in the slot, which is the same as long as the epoch of its name is; or null. */
  public @Nullable UrbiCode code() {
    return holder != null && holder.slotAt(index) instanceof UrbiCode code ? code : null;
  }
}
