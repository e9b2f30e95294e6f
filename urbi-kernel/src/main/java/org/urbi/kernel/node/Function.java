package org.urbi.kernel.node;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.TagStop;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.ast.Ast;

/** A function written in urbiscript (manual, "Code"), with the variables that it captured. */
public final class Function extends Code {
  /** After how many calls, at least, that an exception unwinds others may run; a power of two. */
  private static final int CALLS_PER_BREATH = 1 << 10;

  /** How often others may run, at most, until an exception has unwound half of the calls. */
  private static final int BREATHS_PER_HALF = 4;

  /** How often code is compiled again, because much of what was guessed has turned out wrong. */
  private static final int MOST_VERSIONS = 2;

  /** The part that all closures of one function text share. */
  public static final class Body {
    final Ast.Function source;
    final FrameLayout layout;
    final @Nullable Formals formals;

    /** For each parameter the index of its cell; -1 for plain ones. */
    final int @Nullable [] parameterCells;

    final boolean usesCall;

    /** Whether it is a closure with a {@code return}, which leaves the surrounding function. */
    final boolean leavesHome;

    /** Whether the parameters need no preparation: no cells, defaults or types. */
    final boolean plain;

    private final Node code;
    private @Nullable CompiledCode compiled;
    private int calls;
    private int versions;
    private boolean compiling;

    /**
     * @param code what is executed, when the parameters are ready
     * @param formals null for a lazy function
     * @param usesCall whether the code asks for its call message
     * @param leavesHome whether it is a closure with a {@code return}
     */
    public Body(
        Ast.Function source,
        Node code,
        FrameLayout layout,
        @Nullable Formals formals,
        int @Nullable [] parameterCells,
        boolean usesCall,
        boolean leavesHome) {
      this.source = source;
      this.code = code;
      this.leavesHome = leavesHome;
      this.usesCall = usesCall;
      this.layout = layout;
      this.formals = formals;
      this.parameterCells = parameterCells;
      this.plain = parameterCells == null && (formals == null || !formals.hasDefaults());
      code.standsIn();
    }

    /** What is executed, when the parameters are ready; compiled if it has been executed often. */
    Node code(Frame frame) {
      CompiledCode known = compiled;
      if (known == null
          ? ++calls == frame.interpreter.compiler().threshold()
          : known.isOutdated()) {
        known = compile(frame);
      }
      return known == null ? code : known;
    }

    /** What is executed, when the parameters are ready, as it was written. */
    public Node text() {
      return code;
    }

    /** The defaults of the parameters that have one. */
    public List<Node> defaults() {
      return formals == null ? List.of() : formals.defaults();
    }

    private @Nullable CompiledCode compile(Frame frame) {
      if (!compiling) {
        compiling = true;
        try {
          compiled =
              frame.interpreter.compiler().function(this, code, frame, versions == MOST_VERSIONS);
          versions++;
        } finally {
          compiling = false;
        }
      }
      return compiled;
    }

    /**
     * Has it compiled when it is called the next time, unless it is compiled already, or cannot be.
     *
     * @return whether it will be compiled then
     */
    boolean hasten(CodeCompiler compiler) {
      if (versions > 0 || calls >= compiler.threshold()) {
        return false;
      }
      calls = compiler.threshold() - 1;
      return true;
    }

    /**
     * The compiled code that may be called at once with that many arguments; null if there is none.
     * It is compiled now if it is not yet.
     */
    public @Nullable CompiledCode direct(Frame frame, int arguments) {
      if (!takesPlainly(arguments) || compiling) {
        return null;
      }
      if (compiled == null
          && versions == 0
          && 2 * calls >= frame.interpreter.compiler().threshold()) {
        compile(frame);
      }
      return compiled;
    }

    /** Whether a call with that many arguments just runs the code with them. */
    public boolean takesPlainly(int arguments) {
      return plain && !usesCall && formals != null && formals.isSimple(arguments);
    }

    /** How many parameters there are. */
    public int parameters() {
      return formals == null ? 0 : formals.count();
    }

    /** How many plain variables there are. */
    public int locals() {
      return layout.locals();
    }

    /** Whether there are variables that closures or other jobs can reach. */
    public boolean hasCells() {
      return layout.hasCells();
    }
  }

  private final Body body;
  private final Cell[] captured;

  /** The target of closures; null in functions, whose target is that of the call. */
  private final @Nullable UrbiObject boundSelf;

  /**
   * The lobby with whose permissions the code runs: of closures, and of functions defined in a
   * lobby with limited permissions, so that they do not gain those of their callers. Null for other
   * functions.
   */
  private final @Nullable UrbiObject boundLobby;

  /** The activation that a {@code return} in a closure ends; null when there is none. */
  private final @Nullable Frame home;

  public Function(
      Shape shape,
      Body body,
      Cell[] captured,
      @Nullable UrbiObject boundSelf,
      @Nullable UrbiObject boundLobby,
      @Nullable Frame home) {
    super(shape);
    this.home = home;
    this.body = body;
    this.captured = captured;
    this.boundSelf = boundSelf;
    this.boundLobby = boundLobby;
  }

  /** The text, for printing. */
  public Ast.Function source() {
    return body.source;
  }

  /** The names of its parameters, for people: {@code a, b = …, rest[]}; none for a lazy one. */
  public String parameters() {
    List<Ast.Formal> formals = body.source.formals();
    return formals == null
        ? ""
        : formals.stream()
            .map(each ->
                each.name()
                    + (each.defaultValue() == null ? "" : " = …")
                    + (each.variadic() ? "[]" : ""))
            .collect(Collectors.joining(", "));
  }

  /** Whether another function has captured the same variables and target. */
  public boolean capturesAs(Function other) {
    return boundSelf == other.boundSelf && Arrays.equals(captured, other.captured);
  }

  FrameLayout layout() {
    return body.layout;
  }

  /** The part that all closures of the function text share. */
  public Body body() {
    return body;
  }

  /** Whether a call changes neither the target nor the lobby. */
  public boolean isUnbound() {
    return boundLobby == null;
  }

  /** The same function, with the permissions of that lobby; of one that is unbound. */
  Function boundTo(UrbiObject lobby) {
    Function bound = new Function(cloneShape(), body, captured, boundSelf, lobby, home);
    bound.takeOwnerOf(this);
    return bound;
  }

  boolean usesCall() {
    return body.usesCall;
  }

  boolean isClosure() {
    return body.source.closure();
  }

  @Nullable Frame home() {
    return home;
  }

  Cell[] captured() {
    return captured;
  }

  @Nullable Formals formals() {
    return body.formals;
  }

  @Override
  public boolean isLazy() {
    return body.formals == null;
  }

  @Override
  public UrbiObject call(Frame caller, CallSite site, UrbiObject self, UrbiObject... arguments) {
    return body.formals == null
        ? runLazily(caller, site, self)
        : run(caller, site, self, body.formals.bind(caller, site, this, arguments));
  }

  /**
   * Runs with prepared variables: the parameters first, then room for the others. Not for a lazy
   * function. This is in each call: what makes its frame on the stack larger makes recursion less
   * deep.
   */
  UrbiObject run(Frame caller, CallSite site, UrbiObject self, UrbiObject[] locals) {
    if (boundLobby != null && boundLobby != caller.job.lobby()) {
      return runFor(boundLobby, caller, site, self, locals);
    }
    return caller.interpreter.profiling
        ? runProfiled(caller, site, self, locals)
        : execute(caller, site, self, locals);
  }

  /** Runs a lazy function, for its lobby if that may have the arguments of the caller. */
  UrbiObject runLazily(Frame caller, CallSite site, UrbiObject self) {
    UrbiObject[] locals = body.layout.newLocals();
    return boundLobby != null
            && boundLobby != caller.job.lobby()
            && caller.job.identity().mayLendArgumentsTo(boundLobby)
        ? runFor(boundLobby, caller, site, self, locals)
        : runProfiled(caller, site, self, locals);
  }

  private UrbiObject runFor(
      UrbiObject lobby, Frame caller, CallSite site, UrbiObject self, UrbiObject[] locals) {
    UrbiObject own = caller.job.lobby();
    caller.job.identity().become(lobby);
    try {
      return runProfiled(caller, site, self, locals);
    } finally {
      caller.job.identity().become(own);
    }
  }

  private UrbiObject runProfiled(
      Frame caller, CallSite site, UrbiObject self, UrbiObject[] locals) {
    if (!caller.interpreter.profiling) {
      return execute(caller, site, self, locals);
    }
    Profiler.Stack stack =
        Profiler.enter(caller.job, site.isNamed() ? site.calledName() : "?", body);
    try {
      return execute(caller, site, self, locals);
    } finally {
      if (stack != null) {
        stack.leave();
      }
    }
  }

  private UrbiObject execute(Frame caller, CallSite site, UrbiObject self, UrbiObject[] locals) {
    Frame frame = caller.call(site, boundSelf == null ? self : boundSelf, this, locals);
    caller.interpreter.enter(frame.job, frame.depth);
    if (!body.plain) {
      prepare(frame);
    }
    try {
      return body.code(frame).execute(frame);
    } catch (NonLocalExit.Return | UrbiException | TagStop e) {
      return left(frame, e);
    } finally {
      if (frame.scopeEnd != null) {
        ScopeEnd.leave(frame, null);
      }
    }
  }

  /** An exception leaves a call: it answers with the value of a return, or throws again. */
  static UrbiObject left(Frame frame, RuntimeException leaving) {
    if (leaving instanceof NonLocalExit.Return exit) {
      if (exit.activation() == frame.activation) {
        return exit.value();
      }
    } else if (isBreath(frame.depth)) {
      frame.job.scheduler().interruptions().yieldWhileUnwinding(frame.job);
    }
    throw leaving;
  }

  /**
   * Whether others may run when calls are unwound to that depth. To let them costs time in
   * proportion to the calls that are left, whose stack is copied: so the deeper, the more seldom.
   */
  private static boolean isBreath(int depth) {
    int calls = Math.max(CALLS_PER_BREATH, Integer.highestOneBit(depth) / BREATHS_PER_HALF);
    return (depth & calls - 1) == 0;
  }

  /** Moves the parameters that are shared to their cells, and gives the others their defaults. */
  private void prepare(Frame frame) {
    int[] cells = body.parameterCells;
    if (cells != null) {
      for (int i = 0; i < cells.length; i++) {
        if (cells[i] >= 0) {
          frame.cells[cells[i]] = new Cell(frame.locals[i]);
        }
      }
    }
    if (body.formals != null && body.formals.hasDefaults()) {
      body.formals.bindDefaults(frame);
    }
  }

  @Override
  public UrbiObject cloned() {
    return new Function(cloneShape(), body, captured, boundSelf, boundLobby, home);
  }
}
