package org.urbi.kernel.object;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * What objects of the same build have in common (a "hidden class"): their prototypes, the names of
 * their slots in the order of their creation, and which of these slots are special. A lookup site
 * that has seen a shape knows at which index a slot stands.
 *
 * <p>Shapes are immutable and form a tree of transitions, one by each slot added. Objects with very
 * many slots, and those that lose slots, have a shape of their own which nobody else reaches.
 */
public final class Shape {
  static final UrbiObject[] NO_PROTOS = {};

  /** Writing goes through {@link SlotData}: constant, watched, or with a setter. */
  static final byte WRITE_SPECIAL = 1;

  /** Reading goes through {@link SlotData}: the slot has a getter. */
  static final byte READ_SPECIAL = 2;

  private static final int LINEAR_LIMIT = 8;

  final World world;
  final UrbiObject[] protos;
  final Symbol[] names;
  final byte[] flags;
  private Map<Symbol, Integer> index;
  private Map<Symbol, Shape> additions;

  private Shape(World world, UrbiObject[] protos, Symbol[] names, byte[] flags) {
    this.world = world;
    this.protos = protos;
    this.names = names;
    this.flags = flags;
  }

  static Shape root(World world, UrbiObject[] protos) {
    return new Shape(world, protos, new Symbol[0], new byte[0]);
  }

  /** The kernel's shared state. */
  public World world() {
    return world;
  }

  int size() {
    return names.length;
  }

  /** The index of a slot, or -1. */
  public int indexOf(Symbol name) {
    int size = names.length;
    if (size <= LINEAR_LIMIT) {
      for (int i = 0; i < size; i++) {
        if (names[i] == name) {
          return i;
        }
      }
      return -1;
    }
    if (index == null) {
      index = LinkedHashMap.newLinkedHashMap(size);
      for (int i = 0; i < size; i++) {
        index.put(names[i], i);
      }
    }
    Integer found = index.get(name);
    return found == null ? -1 : found;
  }

  /** Whether writing the slot at this index must go through its {@link SlotData}. */
  public boolean writeSpecial(int i) {
    return (flags[i] & WRITE_SPECIAL) != 0;
  }

  /** Whether reading the slot at this index must go through its {@link SlotData}. */
  public boolean readSpecial(int i) {
    return (flags[i] & READ_SPECIAL) != 0;
  }

  /** This shape and one more slot, at the end. */
  Shape with(Symbol name) {
    Shape next = additions == null ? null : additions.get(name);
    if (next == null) {
      int size = names.length;
      Symbol[] moreNames = Arrays.copyOf(names, size + 1);
      moreNames[size] = name;
      next = new Shape(world, protos, moreNames, Arrays.copyOf(flags, size + 1));
      if (additions == null) {
        additions = new LinkedHashMap<>();
      }
      additions.put(name, next);
    }
    return next;
  }

  /** This shape with other prototypes, for one object only. */
  Shape withProtos(UrbiObject[] others) {
    return new Shape(world, others, names, flags);
  }

  /** This shape with other flags at one index, for one object only. */
  Shape withFlags(int i, byte value) {
    byte[] others = flags.clone();
    others[i] = value;
    return new Shape(world, protos, names, others);
  }

  /** This shape without one slot, for one object only. */
  Shape without(int i) {
    int size = names.length - 1;
    Symbol[] fewerNames = new Symbol[size];
    byte[] fewerFlags = new byte[size];
    System.arraycopy(names, 0, fewerNames, 0, i);
    System.arraycopy(names, i + 1, fewerNames, i, size - i);
    System.arraycopy(flags, 0, fewerFlags, 0, i);
    System.arraycopy(flags, i + 1, fewerFlags, i, size - i);
    return new Shape(world, protos, fewerNames, fewerFlags);
  }
}
