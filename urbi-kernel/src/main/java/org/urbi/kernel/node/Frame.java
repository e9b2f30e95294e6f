package org.urbi.kernel.node;

import java.util.ArrayList;
import java.util.List;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** One activation of a function: its variables, its target, and who called it. */
public final class Frame {
  /** How a statement list ended, when it did not end by itself. */
  enum Completion {
    BREAK,
    CONTINUE,
    RETURN
  }

  static final UrbiObject[] NO_ARGUMENTS = {};
  private static final Cell[] NO_CELLS = {};

  /** The kernel, for those who need more than objects. */
  final Interpreter interpreter;

  final Job job;
  final int depth;

  /** Who called; null at the top level, and in jobs that outlive their caller. */
  final Frame caller;

  /** Where the call was made, or null. */
  final CallSite site;

  /** {@code this}. */
  final UrbiObject self;

  /** The function that runs; null at the top level. */
  final Function function;

  final UrbiObject[] locals;
  final Cell[] cells;
  final Cell[] captured;

  /** Set by {@code break}, {@code continue} and {@code return}; null while all goes on. */
  Completion completion;

  /** The jobs to which the scope being executed has given statements, or null. */
  Background background;

  private Frame(
      Interpreter interpreter,
      Job job,
      int depth,
      Frame caller,
      CallSite site,
      UrbiObject self,
      Function function,
      UrbiObject[] locals,
      Cell[] cells,
      Cell[] captured) {
    this.interpreter = interpreter;
    this.job = job;
    this.depth = depth;
    this.caller = caller;
    this.site = site;
    this.self = self;
    this.function = function;
    this.locals = locals;
    this.cells = cells;
    this.captured = captured;
  }

  /** The frame of code at the top level of a lobby, or called from Java. */
  public static Frame top(Interpreter interpreter, Job job, UrbiObject self, FrameLayout layout) {
    return new Frame(
        interpreter,
        job,
        0,
        null,
        null,
        self,
        null,
        layout.newLocals(),
        layout.newCells(),
        NO_CELLS);
  }

  /** The frame of a call made from this one; the locals begin with the arguments. */
  Frame call(CallSite from, UrbiObject target, Function called, UrbiObject[] arguments) {
    return new Frame(
        interpreter,
        job,
        depth + 1,
        this,
        from,
        target,
        called,
        arguments,
        called.layout().newCells(),
        called.captured());
  }

  /** The same activation with another {@code this}: the body of {@code do}. */
  Frame withSelf(UrbiObject target) {
    return new Frame(
        interpreter, job, depth, caller, site, target, function, locals, cells, captured);
  }

  /**
   * The same activation in another job, with variables of its own but for the cells.
   *
   * @param waited whether the frame waits for that job, so that it is among its callers
   */
  Frame fork(Job other, boolean waited) {
    return new Frame(
        interpreter,
        other,
        depth,
        waited ? caller : null,
        waited ? site : null,
        self,
        function,
        locals.clone(),
        cells.clone(),
        captured);
  }

  /** The same activation, variables included, seen by code that another job evaluates for it. */
  Frame in(Frame evaluator) {
    return evaluator.job == job
        ? this
        : new Frame(
            interpreter,
            evaluator.job,
            depth,
            caller,
            site,
            self,
            function,
            locals,
            cells,
            captured);
  }

  // ------------------------------------------------------------------ for the library

  public Interpreter interpreter() {
    return interpreter;
  }

  public Job job() {
    return job;
  }

  /** {@code this}. */
  public UrbiObject self() {
    return self;
  }

  /** The name by which the innermost function was called; null at the top level. */
  public String calledAs() {
    return site == null ? null : site.calledName();
  }

  /** The calls that are going on, innermost first. */
  public List<UrbiException.Call> backtrace() {
    List<UrbiException.Call> calls = new ArrayList<>();
    for (Frame frame = this; frame != null; frame = frame.caller) {
      if (frame.site != null) {
        calls.add(new UrbiException.Call(frame.site.calledName(), frame.site.calledSpan()));
      }
      if (calls.size() >= 10_000) {
        break;
      }
    }
    return calls;
  }

  /** Says where an exception was thrown, if that is not known yet. */
  UrbiException located(UrbiException exception, Span span) {
    if (!exception.isLocated()) {
      exception.locate(span, backtrace());
    }
    return exception;
  }
}
