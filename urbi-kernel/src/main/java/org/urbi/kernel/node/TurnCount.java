package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;

/**
 * Counts the turns of a loop in all of its executions, and has it compiled when there were enough.
 * An execution counts its own turns in a local variable, which costs less than a field, and adds
 * them in the end.
 */
final class TurnCount {
  /** How often a loop is compiled again, because what was guessed has turned out wrong. */
  private static final int MOST_VERSIONS = 2;

  private long counted;
  private boolean asked;
  private int versions;
  private @Nullable CompiledCode compiled;

  /** The compiled loop; null if there is none. */
  @Nullable CompiledCode compiled() {
    if (compiled != null && compiled.isOutdated()) {
      // A turn from now it is compiled again.
      compiled = null;
      asked = false;
    }
    return compiled;
  }

  /** In which turn of an execution that begins now the loop is to be compiled. */
  long left(CodeCompiler compiler) {
    if (versions > 0 && !asked) {
      return 1;
    }
    long left = compiler.turns() - counted;
    return left > 0 ? left : Long.MAX_VALUE;
  }

  /** Compiles the loop; returns null if it is not worth it. */
  @Nullable CompiledCode compile(Node loop, Frame frame) {
    if (!asked) {
      asked = true;
      compiled = frame.interpreter.compiler().loop(loop, frame, versions == MOST_VERSIONS);
      versions++;
    }
    return compiled;
  }

  /** An execution with so many turns ends. */
  void add(long turns) {
    counted += turns;
  }
}
