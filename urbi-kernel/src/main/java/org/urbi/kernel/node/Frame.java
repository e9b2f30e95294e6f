package org.urbi.kernel.node;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Place;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** One activation of a function: its variables, its target, and who called it. */
public final class Frame implements Place {
  /** The jump that ended a statement list. */
  enum Completion {
    BREAK,
    CONTINUE,
    RETURN
  }

  static final UrbiObject[] NO_ARGUMENTS = {};

  private static final int INNERMOST_CALLS = 100;
  private static final int OUTERMOST_CALLS = 50;

  /** The interpreter. */
  final Interpreter interpreter;

  final Job job;
  final int depth;

  /** The frame of the caller; null at the top level, and in jobs that outlive their caller. */
  final @Nullable Frame caller;

  /** Where the call was made, or null. */
  final @Nullable CallSite site;

  /** {@code this}. */
  final UrbiObject self;

  /** The function that runs; null at the top level. */
  final @Nullable Function function;

  /** The plain variables; compiled code makes room for them when somebody needs to see them. */
  UrbiObject[] locals;

  final Cell[] cells;

  /** What compiled code answers with, if that is a number of which there is no object. */
  double answer;

  /** The first frame of the activation, which identifies it in all of its frames. */
  final Frame activation;

  /** Set by {@code break}, {@code continue} and {@code return}; null during normal execution. */
  @Nullable Completion completion;

  /** The exception that the {@code catch} clause being executed has caught, or null. */
  @Nullable UrbiException caught;

  /** The background jobs of the scope being executed, or null. */
  @Nullable Background background;

  /** The jobs detached by the loop being executed; or null. */
  @Nullable LoopJobs loopJobs;

  /**
   * The end of the innermost scope of this function that has one; null if none has one yet, {@link
   * ScopeEnd#NEVER} outside of all scopes.
   */
  @Nullable ScopeEnd scopeEnd;

  /** The first of the frames that have these very variables, which knows the next two for all. */
  private final Frame keeper;

  /** Whether unevaluated arguments may read and assign the variables at any time. */
  private boolean exposed;

  /** Whether plain variables may have been shared. */
  private boolean sharing;

  private Frame(
      Interpreter interpreter,
      Job job,
      int depth,
      @Nullable Frame caller,
      @Nullable CallSite site,
      UrbiObject self,
      @Nullable Function function,
      UrbiObject[] locals,
      Cell[] cells,
      @Nullable Frame activation,
      @Nullable Frame keeper) {
    this.interpreter = interpreter;
    this.job = job;
    this.depth = depth;
    this.caller = caller;
    this.site = site;
    this.self = self;
    this.function = function;
    this.locals = locals;
    this.cells = cells;
    this.activation = activation == null ? this : activation;
    this.keeper = keeper == null ? this : keeper;
  }

  @Override
  public int depth() {
    return depth;
  }

  /** The frame of code at the top level of a lobby, or called from Java. */
  public static Frame top(Interpreter interpreter, Job job, UrbiObject self, FrameLayout layout) {
    return outsideOfScopes(
        new Frame(
            interpreter,
            job,
            0,
            null,
            null,
            self,
            null,
            layout.newLocals(),
            layout.newCells(),
            null,
            null));
  }

  /** The frame of a call made from this one; the locals begin with the arguments. */
  Frame call(CallSite from, UrbiObject target, Function called, UrbiObject[] arguments) {
    return call(from, target, called, arguments, called.layout().newCells());
  }

  /** The frame of a call, with the variables that closures or other jobs can reach. */
  Frame call(
      CallSite from, UrbiObject target, Function called, UrbiObject[] arguments, Cell[] shared) {
    return new Frame(
        interpreter, job, depth + 1, this, from, target, called, arguments, shared, null, null);
  }

  /** The frame of code evaluated on behalf of a library function called at that site. */
  public Frame nested(@Nullable CallSite from, UrbiObject target, FrameLayout layout) {
    return outsideOfScopes(
        new Frame(
            interpreter,
            job,
            depth + 1,
            this,
            from,
            target,
            null,
            layout.newLocals(),
            layout.newCells(),
            null,
            null));
  }

  /** The plain variables; for those of compiled code there is room from now on. */
  UrbiObject[] room() {
    if (locals.length == 0 && function != null) {
      locals = function.layout().newLocals();
    }
    return locals;
  }

  private static Frame outsideOfScopes(Frame frame) {
    frame.scopeEnd = ScopeEnd.NEVER;
    return frame;
  }

  /** The same activation with another {@code this}: the body of {@code do}. */
  Frame withSelf(UrbiObject target) {
    return inScopeOf(
        this,
        new Frame(
            interpreter,
            job,
            depth,
            caller,
            site,
            target,
            function,
            room(),
            cells,
            activation,
            keeper));
  }

  private static Frame inScopeOf(Frame original, Frame copy) {
    // What the copy adds is done when the original leaves the scope.
    copy.scopeEnd = original.innermostEnd();
    return copy;
  }

  /**
   * The same activation in another job, with a copy of the variables except for those in cells.
   *
   * @param waited whether this frame waits for that job, and so belongs to its callers
   */
  public Frame fork(Job other, boolean waited) {
    return copy(other, waited, null);
  }

  /** The same activation, as if it had been called by this one at that site. */
  Frame through(CallSite from) {
    return inScopeOf(
        this,
        new Frame(
            interpreter,
            job,
            depth + 1,
            this,
            from,
            self,
            function,
            room(),
            cells,
            activation,
            keeper));
  }

  /**
   * Like {@link #fork}, for a job for which the code waits, as if called at that site.
   *
   * @param by the frame of the caller, which all such jobs can share
   */
  Frame forkThrough(Job other, CallSite from, Frame by) {
    return asSharedAs(
        this,
        new Frame(
            interpreter,
            other,
            by.depth + 1,
            by,
            from,
            self,
            function,
            room().clone(),
            copied(cells),
            activation,
            null));
  }

  /**
   * The same activation in a job which outlives it.
   *
   * @param how the call that started the job, for its backtrace
   */
  public Frame detach(Job other, CallSite how) {
    return copy(other, false, how);
  }

  /**
   * The same activation with a copy of its variables.
   *
   * @param how the call shown in backtraces instead of a caller that is not kept, or null
   */
  private Frame copy(Job other, boolean waited, @Nullable CallSite how) {
    boolean kept = keepsCaller(waited);
    return asSharedAs(
        this,
        new Frame(
            interpreter,
            other,
            depth,
            kept ? caller : null,
            kept ? site : how,
            self,
            function,
            room().clone(),
            copied(cells),
            activation,
            null));
  }

  /** From now on each of the two has its own variables, except for those shared until now. */
  private static Frame asSharedAs(Frame original, Frame copy) {
    copy.exposed = original.keeper.exposed;
    copy.sharing = original.keeper.sharing;
    return inScopeOf(original, copy);
  }

  /** Most code has no variables in cells, and needs no copy of nothing. */
  private static Cell[] copied(Cell[] cells) {
    return cells.length == 0 ? cells : cells.clone();
  }

  /**
   * Whether the copy keeps its caller: a job that outlives its caller must not keep it alive,
   * unless its code can ask for it.
   */
  private boolean keepsCaller(boolean waited) {
    return waited || (function != null && function.usesCall());
  }

  /**
   * Shares the plain variables that there are with the copies that are made from now on, since
   * other jobs execute code with them.
   */
  public void shareLocals() {
    exposeLocals();
    keeper.sharing = true;
    for (int i = 0; i < locals.length; i++) {
      @Nullable UrbiObject value = locals[i];
      if (value != null && !(value instanceof SharedLocal)) {
        locals[i] = new SharedLocal(value);
      }
    }
  }

  /** Whether there may be a {@link SharedLocal} among the plain variables. */
  boolean isSharing() {
    return keeper.sharing;
  }

  /** The same activation with the same variables, for code that another job evaluates. */
  public Frame in(Job evaluator) {
    return evaluator == job
        ? this
        : inScopeOf(
            this,
            new Frame(
                interpreter,
                evaluator,
                depth,
                caller,
                site,
                self,
                function,
                room(),
                cells,
                activation,
                keeper));
  }

  /** From now on others may evaluate code that has these very variables. */
  void exposeLocals() {
    keeper.exposed = true;
  }

  /** Whether others may evaluate code that reads and assigns these very variables. */
  boolean isExposed() {
    return keeper.exposed;
  }

  // ------------------------------------------------------------------ for the library

  /** Whether {@code return}, {@code break} or {@code continue} is leaving the surrounding code. */
  public boolean isLeaving() {
    return completion != null;
  }

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

  /** The call message's arguments as code, or null; and the activation to evaluate them in. */
  public @Nullable CallSite site() {
    return site;
  }

  /** The frame of the caller; null at the top level. */
  public @Nullable Frame caller() {
    return caller;
  }

  /** The function that runs; null at the top level. */
  public @Nullable Function function() {
    return function;
  }

  /** What is done when the innermost scope is left, or else the function; null at the top level. */
  public @Nullable ScopeEnd scopeEnd() {
    ScopeEnd end = innermostEnd();
    return end == ScopeEnd.NEVER ? null : end;
  }

  private ScopeEnd innermostEnd() {
    ScopeEnd end = scopeEnd;
    if (end == null) {
      end = new ScopeEnd(null);
      scopeEnd = end;
    }
    return end;
  }

  /** The variables of surrounding code that the function has captured. */
  // No null check, for speed: only the code of a function reads captured variables.
  @SuppressWarnings("NullAway")
  Cell[] captured() {
    return function.captured();
  }

  /** The activation that a {@code return} in the running closure ends; null if there is none. */
  @Nullable Frame home() {
    return function == null ? null : function.home();
  }

  /** Whether an activation is among those that wait for this one to end. */
  boolean isCalledWithin(Frame other) {
    for (Frame frame = caller; frame != null; frame = frame.caller) {
      if (frame.activation == other) {
        return true;
      }
    }
    return false;
  }

  /** Creates the exception for a problem in a function called at that site. */
  public UrbiException error(CallSite at, Problem problem, Object... places) {
    return interpreter.errors().primitive(at.calledName(), problem, places);
  }

  /** The name by which the innermost function was called; null when there is none. */
  public @Nullable String calledAs() {
    return site == null || !site.isNamed() ? null : site.calledName();
  }

  /**
   * The calls in progress, innermost first. Of a runaway recursion only both ends are listed, with
   * the number of calls between them.
   */
  @Override
  public List<UrbiException.Call> backtrace() {
    List<UrbiException.Call> calls = new ArrayList<>();
    ArrayDeque<CallSite> outermost = null;
    int leftOut = 0;
    for (Frame frame = this; frame != null; frame = frame.caller) {
      CallSite from = frame.site;
      if (from == null || !from.isTraced()) {
        continue;
      }
      if (calls.size() < INNERMOST_CALLS) {
        calls.add(call(from));
        continue;
      }
      if (outermost == null) {
        outermost = new ArrayDeque<>();
      }
      outermost.add(from);
      if (outermost.size() > OUTERMOST_CALLS) {
        outermost.remove();
        leftOut++;
      }
    }
    if (leftOut > 0) {
      calls.add(UrbiException.Call.leftOut(leftOut));
    }
    if (outermost != null) {
      outermost.forEach(from -> calls.add(call(from)));
    }
    return calls;
  }

  private static UrbiException.Call call(CallSite from) {
    return new UrbiException.Call(from.calledName(), from.calledSpan());
  }

  /** Places an exception where the running function was called, as one of that function itself. */
  public UrbiException locatedAtCall(UrbiException exception) {
    Frame first = activation;
    if (first.site != null) {
      exception.locate(
          first.site.calledSpan(), first.caller == null ? List.of() : first.caller.backtrace());
    }
    return exception;
  }

  /** Adds to an exception where it was thrown, if that is not known yet. */
  public UrbiException located(UrbiException exception, Span span) {
    if (!exception.isLocated()) {
      exception.locate(span, backtrace());
    }
    return exception;
  }
}
