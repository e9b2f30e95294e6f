package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;

/**
 * Counts the turns of a loop in all of its executions, and has it compiled when there were enough.
 * An execution counts its own turns in a local variable, which costs less than a field, and adds
 * them in the end.
 *
 * <p>A loop whose executions are short is compiled as a part of the loop or function around it, so
 * that its code is emitted only once; one whose executions are long is compiled by itself.
 */
public final class TurnCount {
  /** How often a loop is compiled again, because what was guessed has turned out wrong. */
  private static final int MOST_VERSIONS = 2;

  /** After so many executions, at least, it is known whether they are short. */
  private static final int EXECUTIONS = 10;

  private @Nullable TurnCount around;
  private boolean alone;
  private long counted;
  private int executions;
  private boolean asked;
  private boolean wanted;
  private int versions;
  private @Nullable CompiledCode compiled;

  /** Whether others could reach the variables when it was compiled. */
  private boolean exposed;

  /**
   * The loop stands in the code of a function, of the top level or of another loop, and nothing
   * between them handles exceptions.
   *
   * @param loop that other loop, or null
   */
  void standsIn(@Nullable TurnCount loop) {
    around = loop;
    alone = true;
  }

  /** Whether nobody looks at the variables of the frame when an exception has left the loop. */
  public boolean isAlone() {
    return alone;
  }

  /** Whether the loop is compiled by itself. */
  public boolean isCompiled() {
    return compiled() != null;
  }

  /**
   * The compiled loop for an execution that begins now; null if there is none. Of the code around a
   * loop that is in no function nobody knows what reaches its variables.
   */
  @Nullable CompiledCode compiled(Frame frame) {
    if (frame.function == null && frame.isExposed() && !exposed) {
      forget();
    }
    return compiled();
  }

  private @Nullable CompiledCode compiled() {
    if (compiled != null && compiled.isOutdated()) {
      forget();
    }
    return compiled;
  }

  /** A turn from now it is compiled again. */
  private void forget() {
    if (compiled != null) {
      compiled = null;
      asked = false;
    }
  }

  /** After which turn of an execution that begins now the loop may be hot. */
  long limit(CodeCompiler compiler) {
    if (versions > 0 && !asked) {
      return 1;
    }
    return asked || compiler.turns() == 0
        ? Long.MAX_VALUE
        : Math.max(1, compiler.turns() - counted);
  }

  /** Whether a loop inside of it is hot, and is to be compiled together with it. */
  boolean isWanted() {
    return wanted;
  }

  /**
   * Compiles the loop, or has what is around compiled, after that turn of an execution; returns
   * null if it is not compiled.
   */
  @Nullable CompiledCode compile(Node loop, Frame frame, long turn) {
    wanted = false;
    if (asked || isShort(frame, turn) && isLeft(frame)) {
      return null;
    }
    asked = true;
    exposed = frame.isExposed();
    compiled = frame.interpreter.compiler().loop(loop, frame, versions == MOST_VERSIONS);
    versions++;
    return compiled;
  }

  private boolean isShort(Frame frame, long turn) {
    return alone
        && versions == 0
        && executions >= EXECUTIONS
        && turn < frame.interpreter.compiler().turns();
  }

  /** Whether what is around is going to be compiled. */
  private boolean isLeft(Frame frame) {
    if (around == null) {
      return frame.function != null && frame.function.body().hasten(frame.interpreter.compiler());
    }
    if (around.asked) {
      return false;
    }
    around.wanted = true;
    return true;
  }

  /** After which turn to ask again when it was not compiled after that one. */
  long next(CodeCompiler compiler, long turn) {
    return asked ? Long.MAX_VALUE : turn + compiler.turns();
  }

  /** An execution with so many turns ends. */
  void add(long turns) {
    counted += turns;
    executions++;
  }
}
