package org.urbi.kernel.object;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The slots of an object with very many: names by index, and indexes by name. A removed slot leaves
 * a hole, so that the others keep their index.
 */
final class SlotTable {
  private final Map<Symbol, Integer> index = new HashMap<>();
  private Symbol[] names;
  private byte[] flags;
  private int size;

  SlotTable(Symbol[] names, byte[] flags) {
    this.names = Arrays.copyOf(names, 2 * names.length);
    this.flags = Arrays.copyOf(flags, 2 * names.length);
    this.size = names.length;
    for (int i = 0; i < size; i++) {
      index.put(names[i], i);
    }
  }

  /** The index behind the last slot, holes included. */
  int size() {
    return size;
  }

  int indexOf(Symbol name) {
    Integer found = index.get(name);
    return found == null ? -1 : found;
  }

  /** The name of the slot at an index, which is no hole. */
  Symbol nameAt(int i) {
    return names[i];
  }

  byte flagsAt(int i) {
    return flags[i];
  }

  void setFlags(int i, byte value) {
    flags[i] = value;
  }

  /** Adds a slot at the end. */
  void add(Symbol name) {
    if (size == names.length) {
      names = Arrays.copyOf(names, 2 * size);
      flags = Arrays.copyOf(flags, 2 * size);
    }
    names[size] = name;
    flags[size] = 0;
    index.put(name, size++);
  }

  void remove(int i) {
    index.remove(names[i]);
    names[i] = null;
    flags[i] = 0;
  }

  /** Whether most entries are holes. */
  boolean isSparse() {
    return index.size() < size / 2;
  }

  /** The names, in the order in which the slots were added. */
  Symbol[] names() {
    List<Symbol> there = new ArrayList<>(index.size());
    for (int i = 0; i < size; i++) {
      if (names[i] != null) {
        there.add(names[i]);
      }
    }
    return there.toArray(Symbol[]::new);
  }
}
