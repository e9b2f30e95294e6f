package org.urbi.kernel.compile;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.lang.ast.Declaring;

/**
 * A function, or a statement of the top level, being compiled: the code that runs in one
 * activation.
 */
final class CompilationUnit {
  private final @Nullable CompilationUnit parent;
  private final FrameLayout layout = new FrameLayout();
  private final Map<LocalVariable, Integer> captures = new LinkedHashMap<>();
  private final List<Integer> capturedFrom = new ArrayList<>();
  boolean usesCall;

  /** Whether it is a closure. */
  boolean closure;

  /** Whether there is a {@code return} in it, or in a closure in it. */
  boolean returns;

  /** Declares the variable that holds the call message; null where there is no call message. */
  @Nullable Declaring callKey;

  /** Of the top level. */
  CompilationUnit() {
    parent = null;
  }

  /** Of a function. */
  CompilationUnit(CompilationUnit parent) {
    this.parent = parent;
  }

  /** Notes that it contains a {@code return}, which leaves the function around all closures. */
  void addReturn() {
    returns = true;
    if (closure && parent != null) {
      parent.addReturn();
    }
  }

  FrameLayout layout() {
    return layout;
  }

  /**
   * Where the code of this unit finds a shared variable: the index of a cell, or -1 - n for the
   * capture with index n.
   */
  int cellOf(LocalVariable variable) {
    if (variable.unit() == this) {
      return variable.index();
    }
    Integer known = captures.get(variable);
    if (known == null) {
      known = captures.size();
      captures.put(variable, known);
      capturedFrom.add(requireNonNull(parent, "a variable is of a unit around").cellOf(variable));
    }
    return -1 - known;
  }

  /** For each captured variable, where the surrounding unit finds it. */
  int[] capturedFrom() {
    return capturedFrom.stream().mapToInt(Integer::intValue).toArray();
  }
}
