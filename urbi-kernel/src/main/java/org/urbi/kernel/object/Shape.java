package org.urbi.kernel.object;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * A "hidden class": what objects of the same structure have in common, namely their prototypes, the
 * names of their slots in the order of creation, and which of these slots are special. A lookup
 * site that has seen a shape knows at which index a slot stands.
 *
 * <p>Shapes form a tree, with a transition for each slot added, and are immutable. Only an object
 * with very many slots has a shape of its own with a table, which grows as slots are added. Any
 * change that moves a slot, or affects how it is accessed, gives the object another shape.
 */
public final class Shape {
  static final UrbiObject[] NO_PROTOS = {};
  private static final Symbol[] NO_NAMES = {};
  private static final byte[] NO_FLAGS = {};

  /** Writing goes through {@link SlotData}: constant, watched, or with a setter. */
  static final byte WRITE_SPECIAL = 1;

  /** Reading goes through {@link SlotData}: the slot has a getter. */
  static final byte READ_SPECIAL = 2;

  private static final int LINEAR_LIMIT = 8;

  private static final int SEARCHES_BEFORE_INDEX = 8;

  /** Objects with more slots have a table. */
  private static final int SHARED_LIMIT = 64;

  final World world;
  final UrbiObject[] protos;
  private final Symbol[] names;
  private final byte[] flags;

  /** The slots of an object with very many; null for others, whose slots are the names. */
  private final @Nullable SlotTable table;

  /**
   * Keeps alive the shape from which this one was made, because new objects will pass through it
   * again.
   */
  private final @Nullable Shape parent;

  /**
   * The shape that a number in a slot gets when somebody sees its object; null for other shapes.
   */
  @Nullable Shape whenSeen;

  /** Whether it is that of plain numbers, in slots or not. */
  boolean ofNumbers;

  private @Nullable Map<Symbol, Integer> index;

  /**
   * How many linear searches there were: an index is only built for shapes that are searched often.
   */
  private int searches;

  private @Nullable Transitions additions;

  private Shape(
      World world, UrbiObject[] protos, Symbol[] names, byte[] flags, @Nullable Shape parent) {
    this.world = world;
    this.protos = protos;
    this.names = names;
    this.flags = flags;
    this.table = null;
    this.parent = parent;
  }

  private Shape(World world, UrbiObject[] protos, SlotTable table) {
    this.world = world;
    this.protos = protos;
    this.names = NO_NAMES;
    this.flags = NO_FLAGS;
    this.table = table;
    this.parent = null;
  }

  static Shape root(World world, UrbiObject[] protos) {
    return new Shape(world, protos, NO_NAMES, NO_FLAGS, null);
  }

  /**
   * This is the shape of numbers. Returns that of numbers in slots whose objects nobody has seen,
   * and which get this one then.
   */
  Shape unseen() {
    Shape unseen = root(world, protos);
    unseen.whenSeen = this;
    unseen.ofNumbers = true;
    ofNumbers = true;
    return unseen;
  }

  /** The kernel's shared state. */
  public World world() {
    return world;
  }

  /** The index at which the next slot will stand. */
  int size() {
    return table == null ? names.length : table.size();
  }

  /** The name of the slot at an index, where none has been removed. */
  Symbol nameAt(int i) {
    return table == null ? names[i] : table.nameAt(i);
  }

  /** The names of the slots, in the order of their creation; not to be modified. */
  Symbol[] names() {
    return table == null ? names : table.names();
  }

  /** The index of a slot, or -1. */
  public int indexOf(Symbol name) {
    if (table != null) {
      return table.indexOf(name);
    }
    int size = names.length;
    if (size <= LINEAR_LIMIT || index == null && searches++ < SEARCHES_BEFORE_INDEX) {
      for (int i = 0; i < size; i++) {
        if (names[i] == name) {
          return i;
        }
      }
      return -1;
    }
    if (index == null) {
      index = HashMap.newHashMap(size);
      for (int i = 0; i < size; i++) {
        index.put(names[i], i);
      }
    }
    Integer found = index.get(name);
    return found == null ? -1 : found;
  }

  byte flagsAt(int i) {
    return table == null ? flags[i] : table.flagsAt(i);
  }

  /** Whether writing the slot at this index must go through its {@link SlotData}. */
  public boolean writeSpecial(int i) {
    return (flagsAt(i) & WRITE_SPECIAL) != 0;
  }

  /** Whether reading the slot at this index must go through its {@link SlotData}. */
  public boolean readSpecial(int i) {
    return (flagsAt(i) & READ_SPECIAL) != 0;
  }

  /** This shape and one more slot, at the end. */
  Shape with(Symbol name) {
    if (table != null) {
      table.add(name);
      // Lookups that found the name elsewhere for objects of this shape become invalid.
      name.epoch++;
      return this;
    }
    Shape next = additions == null ? null : additions.get(name);
    if (next == null) {
      int size = names.length;
      Symbol[] moreNames = Arrays.copyOf(names, size + 1);
      byte[] moreFlags = Arrays.copyOf(flags, size + 1);
      moreNames[size] = name;
      if (size == SHARED_LIMIT) {
        return new Shape(world, protos, new SlotTable(moreNames, moreFlags));
      }
      next = new Shape(world, protos, moreNames, moreFlags, this);
      if (additions == null) {
        additions = new Transitions();
      }
      additions.put(name, next);
    }
    return next;
  }

  /** This shape and more slots, at the end, for one object only. */
  Shape withAll(Symbol[] more) {
    if (table != null) {
      for (Symbol name : more) {
        with(name);
      }
      return this;
    }
    int size = names.length;
    Symbol[] all = Arrays.copyOf(names, size + more.length);
    System.arraycopy(more, 0, all, size, more.length);
    byte[] theirs = Arrays.copyOf(flags, all.length);
    return of(world, protos, all, theirs);
  }

  /** A shape for one object only. */
  private static Shape of(World world, UrbiObject[] protos, Symbol[] names, byte[] flags) {
    return names.length > SHARED_LIMIT
        ? new Shape(world, protos, new SlotTable(names, flags))
        : new Shape(world, protos, names, flags, null);
  }

  /** This shape with other prototypes, for one object only. */
  Shape withProtos(UrbiObject[] others) {
    return table == null
        ? new Shape(world, others, names, flags, null)
        : new Shape(world, others, table);
  }

  /** This shape with other flags at one index, for one object only. */
  Shape withFlags(int i, byte value) {
    if (table != null) {
      table.setFlags(i, value);
      return new Shape(world, protos, table);
    }
    byte[] others = flags.clone();
    others[i] = value;
    return new Shape(world, protos, names, others, null);
  }

  /**
   * This shape without one slot, for one object only. With a table the other slots stay where they
   * are; otherwise those behind it move down by one.
   */
  Shape without(int i) {
    if (table != null) {
      table.remove(i);
      return new Shape(world, protos, table);
    }
    int size = names.length - 1;
    Symbol[] fewerNames = new Symbol[size];
    byte[] fewerFlags = new byte[size];
    System.arraycopy(names, 0, fewerNames, 0, i);
    System.arraycopy(names, i + 1, fewerNames, i, size - i);
    System.arraycopy(flags, 0, fewerFlags, 0, i);
    System.arraycopy(flags, i + 1, fewerFlags, i, size - i);
    return new Shape(world, protos, fewerNames, fewerFlags, null);
  }

  /** Whether slots keep their index when others are removed. */
  boolean leavesHoles() {
    return table != null;
  }

  /** Whether there are so many holes that {@link #compact} pays off. */
  boolean isSparse() {
    return table != null && table.isSparse();
  }

  /** This shape without holes: the remaining slots, in their order. */
  Shape compact() {
    if (table == null) {
      return this;
    }
    Symbol[] there = table.names();
    byte[] theirs = new byte[there.length];
    for (int i = 0; i < theirs.length; i++) {
      theirs[i] = table.flagsAt(table.indexOf(there[i]));
    }
    return of(world, protos, there, theirs);
  }
}
