package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** {@code try … catch … else … finally} (manual, "Exceptions"). */
public final class Try extends Node {
  /**
   * A {@code catch} clause.
   *
   * @param pattern null when it catches everything
   * @param guard may be null
   */
  public record Clause(@Nullable Pattern pattern, @Nullable Node guard, Node body) {
    /** Whether its pattern matches the exception; its guard has still to be asked. */
    boolean matches(Frame frame, UrbiException exception) {
      if (pattern == null) {
        return true;
      }
      frame.interpreter.describe(frame, exception);
      return pattern.matches(frame, exception.value());
    }
  }

  private final Node body;
  private final Clause[] clauses;
  private final @Nullable Node elseClause;
  private final @Nullable Node finallyClause;

  /**
   * @param elseClause may be null
   * @param finallyClause may be null
   */
  public Try(
      Span span,
      Node body,
      Clause[] clauses,
      @Nullable Node elseClause,
      @Nullable Node finallyClause) {
    super(span);
    this.body = body;
    this.clauses = clauses;
    this.elseClause = elseClause;
    this.finallyClause = finallyClause;
  }

  public Node body() {
    return body;
  }

  public Clause[] clauses() {
    return clauses;
  }

  public @Nullable Node elseClause() {
    return elseClause;
  }

  public @Nullable Node finallyClause() {
    return finallyClause;
  }

  @Override
  public UrbiObject execute(Frame frame) {
    return finallyClause == null ? executeCatching(frame) : executeFinishing(frame, finallyClause);
  }

  private UrbiObject executeFinishing(Frame frame, Node last) {
    boolean thrown = true;
    UrbiObject value;
    try {
      value = executeCatching(frame);
      thrown = false;
    } finally {
      if (thrown) {
        last.execute(frame);
        // What was thrown goes on, however the clause ends: else a loop could refuse to be stopped.
        frame.completion = null;
      }
    }
    Frame.Completion completion = frame.completion;
    frame.completion = null;
    UrbiObject lastValue = last.execute(frame);
    if (frame.completion != null) {
      return lastValue;
    }
    frame.completion = completion;
    return value;
  }

  private UrbiObject executeCatching(Frame frame) {
    UrbiObject value;
    try {
      value = body.execute(frame);
    } catch (UrbiException e) {
      return handle(frame, caught(frame, e));
    } catch (StackOverflowError | OutOfMemoryError e) {
      return handle(frame, this.<Error>caught(frame, e));
    }
    return elseClause == null || frame.completion != null ? value : elseClause.execute(frame);
  }

  /** The exception that clauses get to see; whatever none may handle is thrown again. */
  <T extends Throwable> UrbiException caught(Frame frame, T thrown) throws T {
    if (thrown instanceof UrbiException exception && !exception.isUncatchable()) {
      return exception;
    }
    if (thrown instanceof StackOverflowError) {
      return exhausted(frame, Problem.STACK_EXHAUSTED);
    }
    if (thrown instanceof OutOfMemoryError) {
      frame.interpreter.scheduler().memory().await();
      return exhausted(frame, Problem.MEMORY_EXHAUSTED);
    }
    throw thrown;
  }

  private UrbiException exhausted(Frame frame, Problem problem) {
    return frame.located(frame.interpreter.errors().scheduling(problem), span());
  }

  private UrbiObject handle(Frame frame, UrbiException exception) {
    for (Clause clause : clauses) {
      if (!clause.matches(frame, exception) || clause.guard != null && !clause.guard.test(frame)) {
        continue;
      }
      UrbiException outer = frame.caught;
      frame.caught = exception;
      try {
        return clause.body.execute(frame);
      } finally {
        frame.caught = outer;
      }
    }
    throw exception;
  }
}
