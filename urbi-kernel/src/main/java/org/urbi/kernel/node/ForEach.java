package org.urbi.kernel.node;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.ast.Ast.Flavor;
import org.urbi.lang.source.Span;

/**
 * {@code for (var x : range) body}: sends {@code each} (or {@code each|}, {@code each&}) to the
 * range. Numbers and lists are iterated directly if their {@code each} is the library's.
 */
public final class ForEach extends Node implements CallSite {
  private final Flavor flavor;
  private final Variables.Place variable;
  private final Node range;
  private final Node body;
  private final Symbol each;
  private final SlotLookup lookup;
  private final CallSite entry;
  private final TurnCount turns = new TurnCount();

  /** The call that backtraces show for the turns of a loop. */
  private record Entry(String calledName, Span calledSpan) implements CallSite {}

  public ForEach(
      Span span,
      Interpreter interpreter,
      Flavor flavor,
      Variables.Place variable,
      Node range,
      Node body) {
    super(span);
    this.flavor = flavor;
    this.variable = variable;
    this.range = range;
    this.body = body;
    this.entry = new Entry("[]", span);
    CoreSymbols symbols = interpreter.symbols();
    this.each =
        switch (flavor) {
          case SEMICOLON -> symbols.each;
          case PIPE -> symbols.eachTight;
          case AND, COMMA -> symbols.eachConcurrent;
        };
    this.lookup = new SlotLookup(interpreter.world(), each);
  }

  public Variables.Place variable() {
    return variable;
  }

  public Node range() {
    return range;
  }

  public Node body() {
    return body;
  }

  /** Whether others may run after each turn. */
  public boolean yields() {
    return flavor == Flavor.SEMICOLON;
  }

  /** Whether its turns come one after the other. */
  public boolean isSequential() {
    return flavor == Flavor.SEMICOLON || flavor == Flavor.PIPE;
  }

  public TurnCount turns() {
    return turns;
  }

  @Override
  void standsIn(@Nullable TurnCount loop) {
    if (isSequential()) {
      turns.standsIn(loop);
      body.standsIn(turns);
    }
  }

  @Override
  public String calledName() {
    return each.name();
  }

  @Override
  public Span calledSpan() {
    return range.span().to(span());
  }

  @Override
  public UrbiObject execute(Frame frame) {
    return iterate(frame, ArgumentEvaluation.notVoid(frame, range, span()));
  }

  /** Runs the loop over a range that has been evaluated. */
  UrbiObject iterate(Frame frame, UrbiObject over) {
    LoopJobs jobs = LoopJobs.begin(frame);
    boolean broken = false;
    try {
      UrbiObject value = over(frame, over);
      broken = frame.completion == Frame.Completion.BREAK;
      if (broken) {
        frame.completion = null;
      }
      return value;
    } catch (NonLocalExit.Break leave) {
      broken = true;
      return frame.interpreter.values().voidObject;
    } finally {
      jobs.end(frame, broken);
    }
  }

  private UrbiObject over(Frame frame, UrbiObject range) {
    if (range instanceof UrbiFloat number && isOfLibrary(range)) {
      return overNumber(frame, number.value());
    }
    if (range instanceof UrbiList list && isOfLibrary(range)) {
      return overList(frame, list);
    }
    return send(frame, range);
  }

  boolean isOfLibrary(UrbiObject over) {
    UrbiObject found = lookup.findPlain(over);
    return found instanceof Code code && code.name() != null;
  }

  private UrbiObject overNumber(Frame frame, double count) {
    var values = frame.interpreter.values();
    if (flavor == Flavor.AND || flavor == Flavor.COMMA) {
      try (Background group = new Background(frame.job)) {
        Frame by = frame.through(entry);
        for (long i = 0; i < count; i++) {
          group.start(frame, body, variable, values.number(i), this, by);
        }
        frame.job.at(frame, this);
        group.join();
      }
      return values.voidObject;
    }
    CompiledCode compiled = turns.compiled(frame);
    return compiled == null ? interpret(frame, count) : compiled.run(frame, 0, count);
  }

  /** Executes the turns, until the loop is over or compiled. */
  private UrbiObject interpret(Frame frame, double count) {
    var values = frame.interpreter.values();
    CodeCompiler compiler = frame.interpreter.compiler();
    long limit = turns.limit(compiler);
    long turn = 0;
    try {
      for (long i = 0; i < count; i++) {
        UrbiObject value = turn(frame, values.number(i));
        if (value != null) {
          return value;
        }
        if (flavor == Flavor.SEMICOLON) {
          frame.job.yield(frame, this);
        } else {
          frame.job.checkInterrupted();
        }
        if (++turn >= limit || turns.isWanted()) {
          CompiledCode compiled = turns.compile(this, frame, turn);
          if (compiled != null) {
            return compiled.run(frame, i + 1, count);
          }
          limit = turns.next(compiler, turn);
        }
      }
      return values.voidObject;
    } finally {
      turns.add(turn);
    }
  }

  private UrbiObject overList(Frame frame, UrbiList list) {
    var values = frame.interpreter.values();
    List<UrbiObject> elements = List.copyOf(list.elements());
    if (flavor == Flavor.AND || flavor == Flavor.COMMA) {
      try (Background group = new Background(frame.job)) {
        Frame by = frame.through(entry);
        for (UrbiObject element : elements) {
          group.start(frame, body, variable, element, this, by);
        }
        frame.job.at(frame, this);
        group.join();
      }
      return values.voidObject;
    }
    CompiledCode compiled = turns.compiled(frame);
    if (compiled != null) {
      return compiled.over(frame, 0, elements);
    }
    int last = elements.size() - 1;
    CodeCompiler compiler = frame.interpreter.compiler();
    long limit = turns.limit(compiler);
    long turn = 0;
    try {
      for (int i = 0; i <= last; i++) {
        UrbiObject value = turn(frame, elements.get(i));
        if (value != null) {
          return value;
        }
        if (flavor != Flavor.SEMICOLON) {
          frame.job.checkInterrupted();
        } else if (i < last) {
          frame.job.yield(frame, this);
        }
        if (++turn >= limit || turns.isWanted()) {
          compiled = turns.compile(this, frame, turn);
          if (compiled != null) {
            return compiled.over(frame, i + 1, elements);
          }
          limit = turns.next(compiler, turn);
        }
      }
      return values.voidObject;
    } finally {
      turns.add(turn);
    }
  }

  /** Executes one turn; returns the result of the loop if that was the last one, otherwise null. */
  private @Nullable UrbiObject turn(Frame frame, UrbiObject element) {
    variable.declare(frame, element);
    UrbiObject value;
    try {
      value = body.execute(frame);
    } catch (NonLocalExit.Continue leave) {
      return null;
    }
    if (frame.completion == null) {
      return null;
    }
    return switch (frame.completion) {
      case RETURN -> value;
      case BREAK -> frame.interpreter.values().voidObject;
      case CONTINUE -> {
        frame.completion = null;
        yield null;
      }
    };
  }

  /** Any other range: gives its {@code each} the body as a function. */
  private UrbiObject send(Frame frame, UrbiObject over) {
    UrbiObject action = new Body(frame.interpreter.prototypes.codeShape, frame);
    try {
      frame.interpreter.send(frame, this, over, each, action);
    } catch (UrbiException e) {
      // The error about a missing {@code each} is reported where it would be called: at the body.
      throw frame.located(e, over.lookup(each) == null ? body.span() : range.span());
    }
    return frame.interpreter.values().voidObject;
  }

  /** The body of the loop as a function of one argument. */
  private final class Body extends Code {
    private final Frame home;
    private final UrbiObject lobby;

    Body(Shape shape, Frame home) {
      super(shape);
      this.home = home;
      this.lobby = home.job.lobby();
    }

    @Override
    public boolean isLazy() {
      return false;
    }

    @Override
    public UrbiObject call(Frame caller, CallSite site, UrbiObject self, UrbiObject... arguments) {
      if (arguments.length != 1) {
        throw caller.interpreter.errors().arity(site.calledName(), arguments.length, 1, 1);
      }
      Frame frame = caller.job == home.job ? home : home.fork(caller.job, true);
      variable.declare(frame, arguments[0]);
      UrbiObject value = caller.job.identity().doFor(lobby, () -> body.execute(frame));
      if (frame.completion != null) {
        Frame.Completion completion = frame.completion;
        frame.completion = null;
        switch (completion) {
          case RETURN -> throw new NonLocalExit.Return(frame.activation, value);
          case BREAK -> throw new NonLocalExit.Break();
          case CONTINUE -> {}
        }
      }
      return value;
    }
  }
}
