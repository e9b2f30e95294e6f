package org.urbi.kernel.node;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Dependencies;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.SlotData;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/**
 * An inline cache: looks up a slot by name for one place in the code, and remembers for each shape
 * that it has seen where the slot was. An entry is valid as long as the epoch of the name stays the
 * same.
 */
public final class SlotLookup {
  private static final int LIMIT = 6;

  /** The index in an entry for targets that have no such slot. */
  private static final int ABSENT = -1;

  /** Where the slot of one shape of targets is. */
  private static final class Entry {
    final Shape shape;
    final int epoch;

    /** Null when the target itself has the slot. */
    final @Nullable UrbiObject holder;

    /** {@link #ABSENT} if nobody has it. */
    final int index;

    final @Nullable OwnCode own;
    final @Nullable Entry next;

    Entry(
        Shape shape,
        int epoch,
        @Nullable UrbiObject holder,
        int index,
        @Nullable OwnCode own,
        @Nullable Entry next) {
      this.shape = shape;
      this.epoch = epoch;
      this.holder = holder;
      this.index = index;
      this.own = own;
      this.next = next;
    }

    /** The value of the slot for such a target; null if there is none. */
    @Nullable UrbiObject value(UrbiObject target) {
      if (index == ABSENT) {
        return null;
      }
      return (holder == null ? target : holder).slotAt(index);
    }
  }

  private final World world;
  private final Symbol name;
  private @Nullable Entry entries;

  SlotLookup(World world, Symbol name) {
    this.world = world;
    this.name = name;
  }

  /** The name of the slots. */
  public Symbol name() {
    return name;
  }

  /**
   * Where the slots of one shape of targets are, as long as the epoch of the name stays the same.
   *
   * @param holder whose slot it is; null if the target itself has it
   * @param index the index among the slots of its holder
   * @param own what the target of the first of these lookups had there, if it was its own slot and
   *     held code; otherwise null
   */
  public record Known(Shape shape, @Nullable UrbiObject holder, int index, @Nullable OwnCode own) {}

  /**
   * Code in a slot of the target itself. Other targets of the same shape may have other code there,
   * or none.
   *
   * @param body the code of the function; null if it is none
   */
  public record OwnCode(Function.@Nullable Body body) {
    private static @Nullable OwnCode of(UrbiObject value) {
      if (value instanceof Function function && function.isUnbound()) {
        return new OwnCode(function.body());
      }
      return value instanceof Code ? new OwnCode(null) : null;
    }
  }

  /** What has been found here until now and is still valid, last things first. */
  public List<Known> known() {
    List<Known> known = new ArrayList<>();
    for (Entry entry = entries; entry != null; entry = entry.next) {
      if (entry.epoch == name.epoch() && entry.index != ABSENT) {
        known.add(new Known(entry.shape, entry.holder, entry.index, entry.own));
      }
    }
    return known;
  }

  /** The value of the slot, or null; a getter is called. */
  @Nullable UrbiObject find(Frame frame, UrbiObject target) {
    if (world.tracker == null) {
      Shape shape = target.shape();
      for (Entry entry = entries; entry != null; entry = entry.next) {
        if (entry.shape == shape && entry.epoch == name.epoch()) {
          return entry.value(target);
        }
      }
      return remember(frame, target);
    }
    return find(frame, target, name);
  }

  /** The stored value of the slot, or null: no getter is called, and nobody is told. */
  @Nullable UrbiObject findPlain(UrbiObject target) {
    for (Entry entry = entries; entry != null; entry = entry.next) {
      if (entry.shape == target.shape() && entry.epoch == name.epoch()) {
        return entry.value(target);
      }
    }
    UrbiObject holder = target.locate(name);
    if (holder == null) {
      remember(target, null, ABSENT);
      return null;
    }
    int index = holder.shape().indexOf(name);
    if (!holder.shape().readSpecial(index)) {
      remember(target, holder, index);
    }
    return holder.slotAt(index);
  }

  private @Nullable UrbiObject remember(Frame frame, UrbiObject target) {
    UrbiObject holder = target.locate(name);
    if (holder == null) {
      remember(target, null, ABSENT);
      return null;
    }
    int index = holder.shape().indexOf(name);
    if (holder.shape().readSpecial(index)) {
      return read(frame, target, holder, name);
    }
    remember(target, holder, index);
    return holder.slotAt(index);
  }

  private void remember(UrbiObject target, @Nullable UrbiObject holder, int index) {
    // Drops invalid entries, and the oldest one if there are too many.
    Entry kept = null;
    int count = 0;
    for (Entry entry = entries; entry != null && count < LIMIT - 1; entry = entry.next) {
      if (entry.epoch == name.epoch() && entry.shape != target.shape()) {
        kept = new Entry(entry.shape, entry.epoch, entry.holder, entry.index, entry.own, kept);
        count++;
      }
    }
    boolean isOwn = holder == target;
    entries =
        new Entry(
            target.shape(),
            world.remember(name),
            isOwn ? null : holder,
            index,
            isOwn ? OwnCode.of(target.slotAt(index)) : null,
            kept);
  }

  /** The value of a slot, or null, without a cache; a getter is called. */
  static @Nullable UrbiObject find(Frame frame, UrbiObject target, Symbol name) {
    UrbiObject holder = target.locate(name);
    Dependencies.Tracker tracker = target.world().tracker;
    if (holder == null) {
      target.noteAbsence();
      return null;
    }
    SlotData data = holder.slotData(name);
    UrbiObject value = holder.localSlot(name);
    // Functions and constants do not change, so they are not tracked.
    if (tracker != null && (data != null || !(value instanceof Code))) {
      if (holder != target) {
        target.noteStructureRead();
      }
      if (data == null || !data.isConstant()) {
        holder.noteSlotRead(name);
      }
    }
    return data != null && data.getter() != null
        ? frame.interpreter.call(frame, data.getter(), target)
        : value;
  }

  /** The stored value of a slot, or null: no getter is called. */
  static @Nullable UrbiObject findRaw(UrbiObject target, Symbol name) {
    UrbiObject holder = target.locate(name);
    if (holder == null) {
      target.noteAbsence();
      return null;
    }
    if (target.world().tracker != null && !(holder.localSlot(name) instanceof Code)) {
      if (holder != target) {
        target.noteStructureRead();
      }
      holder.noteSlotRead(name);
    }
    return holder.localSlot(name);
  }

  private static @Nullable UrbiObject read(
      Frame frame, UrbiObject target, UrbiObject holder, Symbol name) {
    SlotData data = holder.slotData(name);
    if (data != null && data.getter() != null) {
      return frame.interpreter.call(frame, data.getter(), target);
    }
    return holder.localSlot(name);
  }
}
