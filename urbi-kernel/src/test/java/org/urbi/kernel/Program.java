package org.urbi.kernel;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/**
 * A piece of a program: parts, what stands around them and what stands between two of them. A piece
 * without parts is what stands around.
 */
record Program(String before, List<Program> parts, String between, String after) {
  private static final int MOST_ATTEMPTS = 400;

  /** A piece that has no parts. */
  static Program of(String text) {
    return new Program(text, List.of(), "", "");
  }

  String text() {
    return parts.stream().map(Program::text).collect(Collectors.joining(between, before, after));
  }

  /**
   * The smallest program like this one of which the same still holds, as far as it is found by
   * leaving out parts, and by putting parts in the place of their whole.
   */
  Program shrunk(Predicate<Program> holds) {
    Program smallest = this;
    int attempts = 0;
    boolean smaller = true;
    while (smaller) {
      smaller = false;
      for (Program candidate : smallest.smaller()) {
        if (attempts++ == MOST_ATTEMPTS) {
          return smallest;
        }
        if (holds.test(candidate)) {
          smallest = candidate;
          smaller = true;
          break;
        }
      }
    }
    return smallest;
  }

  /** This program with one thing less, in every way; what leaves out most comes first. */
  private List<Program> smaller() {
    List<Program> all = new ArrayList<>();
    if (parts.size() > 3) {
      int half = parts.size() / 2;
      all.add(with(parts.subList(0, half)));
      all.add(with(parts.subList(half, parts.size())));
    }
    all.addAll(parts);
    for (int i = 0; i < parts.size(); i++) {
      if (parts.size() > 1) {
        List<Program> fewer = new ArrayList<>(parts);
        fewer.remove(i);
        all.add(with(fewer));
      }
    }
    for (int i = 0; i < parts.size(); i++) {
      for (Program other : parts.get(i).smaller()) {
        List<Program> changed = new ArrayList<>(parts);
        changed.set(i, other);
        all.add(with(changed));
      }
    }
    return all;
  }

  private Program with(List<Program> others) {
    return new Program(before, List.copyOf(others), between, after);
  }
}
