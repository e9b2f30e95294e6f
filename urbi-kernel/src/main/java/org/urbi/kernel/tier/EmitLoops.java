package org.urbi.kernel.tier;

import static java.lang.constant.ConstantDescs.CD_boolean;
import static java.lang.constant.ConstantDescs.CD_double;
import static java.lang.constant.ConstantDescs.CD_int;
import static java.lang.constant.ConstantDescs.CD_void;

import java.lang.classfile.Label;
import java.lang.classfile.instruction.SwitchCase;
import java.lang.constant.MethodTypeDesc;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.ForEach;
import org.urbi.kernel.node.Loops;
import org.urbi.kernel.node.Node;

/** Emits loops, and the ways to leave them and the function. */
final class EmitLoops {
  /** What {@code leaving} answers. */
  private static final int RETURN = 0;

  private static final int BREAK = 1;
  private static final int NO_JOBS = -1;

  private final Emitter to;
  private final Deque<Loop> around = new ArrayDeque<>();
  private Copy copy = Copy.ONLY;

  private final Crossings crossings = new Crossings();

  EmitLoops(Emitter to) {
    this.to = to;
  }

  /**
   * A loop whose body is being emitted.
   *
   * @param next where its next turn begins
   * @param broken where it ends by {@code break}
   * @param jobs the slot of the jobs that it has detached; -1 if it detaches none, or the caller of
   *     this code has them
   * @param handled whether its jumps may come as exceptions
   */
  private record Loop(Label next, Label broken, int jobs, boolean handled) {}

  /** The parts of a loop in which the kinds of loops differ. */
  private interface Parts {
    /** Emits the condition; jumps if the loop is over. */
    void head(Label over);

    /** Emits what follows a turn, and jumps to the next one. */
    void step(Heads heads);
  }

  /**
   * Where the turns of a loop begin. For the Java machine those after which others may have run are
   * the turns of a loop around the other turns, so that it keeps numbers in registers in these.
   */
  private record Heads(Label usual, Label afterOthers) {}

  /**
   * The turns of some loops that count their {@code ;} are emitted twice. In the quick copy there
   * is nothing but counting down at a {@code ;}, so that the Java machine has no calls in it, after
   * which everything would have to be as it was. When nothing is left, or a number is none, the
   * slow copy goes on at the same place, until the end of the turn.
   */
  private enum Copy {
    ONLY,
    SLOW,
    QUICK
  }

  static boolean canCount(ForEach loop) {
    return loop.isSequential() && loop.variable().declaredLocal() >= 0;
  }

  boolean isInLoop() {
    return !around.isEmpty();
  }

  /** How many loops are around what is being emitted. */
  int around() {
    return around.size();
  }

  /** Whether there are exceptions that do not leave the function. */
  boolean isHandling() {
    return around.stream().anyMatch(Loop::handled);
  }

  // ------------------------------------------------------------------ loops inside other code

  Value value(Loops.Sequential loop) {
    inside(
        loop,
        () -> {
          if (loop.init() != null) {
            to.operand(loop.init());
          }
        },
        loop.body(),
        parts(loop));
    return to.voidValue();
  }

  Value value(ForEach loop) {
    Label other = to.code.newLabel();
    Label over = to.code.newLabel();
    Value given = to.operand(loop.range());
    to.located(loop, () -> to.notVoid(given));
    to.load(given);
    Value range = to.storedObject();
    Label counted = to.code.newLabel();
    int count = to.newNumber();
    int elements = to.newObject();
    to.code.aload(range.object());
    to.constant(loop, Names.FOR_EACH);
    to.help("elements", Names.OBJECTS, Names.OBJECT, Names.FOR_EACH);
    to.code.dup().astore(elements);
    Label noList = to.code.newLabel();
    to.code.ifnull(noList);
    to.code.aload(elements).arraylength().i2d().dstore(count).goto_(counted);
    to.code.labelBinding(noList);
    to.code.aload(range.object());
    to.constant(loop, Names.FOR_EACH);
    to.help("isCount", CD_boolean, Names.OBJECT, Names.FOR_EACH);
    to.code.ifeq(other);
    to.code.aload(range.object());
    to.help("number", CD_double, Names.OBJECT);
    to.code.dstore(count);
    to.code.labelBinding(counted);
    int turn = to.newNumber();
    to.code.dconst_0().dstore(turn);
    inside(loop, () -> {}, loop.body(), counting(loop, turn, count, elements));
    Value result = to.voidValue();
    to.code.goto_(over);
    to.code.labelBinding(other);
    Value value =
        to.beside(
            loop,
            () -> {
              to.code.aload(range.object());
              to.frame();
              to.constant(loop, Names.FOR_EACH);
              to.place();
              to.help(
                  "iterate", Names.OBJECT, Names.OBJECT, Names.FRAME, Names.FOR_EACH, Names.NODE);
            });
    leaveIfAsked(value);
    to.code.aload(value.object()).astore(result.object());
    to.code.labelBinding(over);
    return result;
  }

  private void inside(Node node, Runnable init, Node body, Parts parts) {
    if (mayDetach(node)) {
      insideWithJobs(init, body, parts);
      return;
    }
    Label over = to.code.newLabel();
    init.run();
    boolean counts = counts(node);
    if (counts) {
      to.beginCounting();
    }
    Loop loop =
        new Loop(to.code.newLabel(), to.code.newLabel(), NO_JOBS, Survey.of(body).mayJump());
    turns(loop, body, parts, over);
    to.code.labelBinding(loop.broken());
    to.code.labelBinding(over);
    if (counts) {
      to.endCounting();
    }
  }

  /**
   * Whether jobs may be detached in a loop: by its code, by an operator that does so, or by code
   * that has been handed out before and is evaluated by what the loop calls.
   */
  private boolean mayDetach(Node loop) {
    Survey inside = Survey.of(loop);
    boolean evaluates = to.survey().handsOutJobs();
    return inside.mayDetach()
        || evaluates && inside.mayCallUnseen()
        || inside.messages().stream()
            .anyMatch(message ->
                (evaluates || message.argumentNodes().length > 0)
                    && !to.callees().callsNobody(message));
  }

  /**
   * Whether the {@code ;} in a loop are counted in the code itself: if it calls nobody, so that
   * there are many of them before somebody else has to know how many.
   */
  private boolean counts(Node loop) {
    Survey turns = Survey.ofTurns(loop);
    return turns.pausesOften()
        && turns.messages().stream().allMatch(message -> to.callees().callsNobody(message));
  }

  /** Emits a loop that may detach jobs. */
  private void insideWithJobs(Runnable init, Node body, Parts parts) {
    int jobs = to.newObject();
    Loop loop = new Loop(to.code.newLabel(), to.code.newLabel(), jobs, true);
    to.frame();
    to.help("beginLoop", Names.LOOP_JOBS, Names.FRAME);
    to.code.astore(jobs);
    Label start = to.code.newBoundLabel();
    init.run();
    Label done = to.code.newLabel();
    Label over = to.code.newLabel();
    turns(loop, body, parts, done);
    Label end = to.code.newBoundLabel();
    Label handler = to.code.newBoundLabel();
    end(loop, false);
    to.code.athrow();
    to.code.exceptionCatchAll(start, end, handler);
    to.code.labelBinding(done);
    end(loop, false);
    to.code.goto_(over);
    to.code.labelBinding(loop.broken());
    end(loop, true);
    to.code.labelBinding(over);
  }

  private void end(Loop loop, boolean broken) {
    to.frame();
    to.code.aload(loop.jobs()).loadConstant(broken ? 1 : 0);
    to.help("endLoop", CD_void, Names.FRAME, Names.LOOP_JOBS, CD_boolean);
  }

  // ------------------------------------------------------------------ a loop as a unit

  /** Emits a loop that is running, from its condition on; the caller has begun it, and ends it. */
  void unit(Node node) {
    boolean counts = counts(node) && !Survey.of(node).mayDetach();
    if (counts) {
      to.beginCounting();
    }
    Loop loop =
        new Loop(to.code.newLabel(), to.code.newLabel(), NO_JOBS, Survey.of(node).mayJump());
    Label done = to.code.newLabel();
    Label start = to.code.newBoundLabel();
    if (node instanceof ForEach forEach) {
      Parts parts = counting(forEach, Emitter.FROM, Emitter.TO, Emitter.ELEMENTS);
      turns(loop, forEach.body(), parts, done);
    } else if (node instanceof Loops.Sequential sequential) {
      turns(loop, sequential.body(), parts(sequential), done);
    }
    if (to.isObserved()) {
      Label end = to.code.newBoundLabel();
      Label handler = to.code.newBoundLabel();
      to.afterOthers();
      to.writeAll();
      to.code.athrow();
      to.code.exceptionCatchAll(start, end, handler);
    }
    to.code.labelBinding(loop.broken());
    to.frame();
    to.help("breaks", CD_void, Names.FRAME);
    to.code.labelBinding(done);
    if (counts) {
      to.endCounting();
    }
    to.writeAll();
    to.loadVoid();
    to.code.areturn();
  }

  // ------------------------------------------------------------------ the turns

  private Parts parts(Loops.Sequential loop) {
    return new Parts() {
      @Override
      public void head(Label over) {
        if (loop.condition() != null) {
          to.condition(loop.condition(), over);
        }
      }

      @Override
      public void step(Heads heads) {
        if (loop.step() != null) {
          to.operand(loop.step());
        }
        pause(loop.yields(), loop.body(), heads);
      }
    };
  }

  /** Lets others run, or only asks whether somebody wants to end this. */
  private void pause(boolean yields, Node after, Heads heads) {
    if (yields) {
      yieldToOthers(after, heads.usual());
      if (!isQuick()) {
        to.code.goto_(heads.afterOthers());
      }
    } else {
      if (to.isCounting()) {
        to.job();
        to.code.invokevirtual(Names.JOB, "mayBeInterrupted", MethodTypeDesc.of(CD_boolean));
        to.code.ifeq(heads.usual());
      }
      to.callJob("checkInterrupted");
      to.code.goto_(heads.usual());
    }
  }

  /** A loop over numbers; or over elements, if there are any. */
  private Parts counting(ForEach loop, int turn, int count, int elements) {
    Value variable = to.variable(loop.variable().declaredLocal());
    return new Parts() {
      @Override
      public void head(Label over) {
        Label number = to.code.newLabel();
        Label set = to.code.newLabel();
        to.code.dload(turn).dload(count).dcmpg().ifge(over);
        to.code.aload(elements).ifnull(number);
        to.code.aload(elements).dload(turn).d2i().aaload().astore(variable.object());
        to.code.goto_(set);
        to.code.labelBinding(number);
        to.code.dload(turn).dstore(variable.number());
        to.code.aconst_null().astore(variable.object());
        to.code.labelBinding(set);
        to.code.dload(turn).dconst_1().dadd().dstore(turn);
        to.afterDeclaration(variable);
      }

      @Override
      public void step(Heads heads) {
        if (loop.yields()) {
          // After the last element nobody else runs.
          Label pauses = to.code.newLabel();
          to.code.aload(elements).ifnull(pauses);
          to.code.dload(turn).dload(count).dcmpg().ifge(heads.usual());
          to.code.labelBinding(pauses);
        }
        pause(loop.yields(), loop.body(), heads);
      }
    };
  }

  private void turns(Loop loop, Node body, Parts parts, Label done) {
    Label afterOthers = to.beginRange();
    if (!isCopied(loop, body)) {
      turn(loop, body, parts, new Heads(to.code.newBoundLabel(), afterOthers), done);
      return;
    }
    Label usual = to.code.newLabel();
    to.code.iload(to.passing()).ifgt(usual);
    copy(Copy.SLOW, loop, body, parts, afterOthers, done);
    to.code.labelBinding(usual);
    Loop again = new Loop(to.code.newLabel(), loop.broken(), loop.jobs(), false);
    copy(Copy.QUICK, again, body, parts, usual, done);
    crossings.end();
  }

  /**
   * Whether the turns are emitted twice: the Java machine takes longer to compile them then, which
   * pays if a {@code ;} in the body is as much work as what is around it.
   */
  private boolean isCopied(Loop loop, Node body) {
    return to.isCounting()
        && !loop.handled()
        && to.unit.copiesLoops()
        && Survey.of(body).isMostlyPauses();
  }

  /**
   * Where an operation is done if something is not as expected: in the quick copy of a loop, in the
   * slow one, which goes on from there.
   */
  Label unexpected(Node operation) {
    if (isQuick()) {
      return crossings.next(operation, to.taken());
    }
    Label label = to.code.newLabel();
    if (copy == Copy.SLOW) {
      crossings.add(operation, to.taken(), label);
    }
    return label;
  }

  /** Whether a copy is emitted that leaves to another one what is not as expected. */
  boolean isQuick() {
    return copy == Copy.QUICK;
  }

  /** Emits a copy of the turns. In both the same values are in the same slots. */
  private void copy(Copy which, Loop loop, Node body, Parts parts, Label head, Label done) {
    copy = which;
    to.releasing(() -> turn(loop, body, parts, new Heads(head, head), done));
    copy = Copy.ONLY;
  }

  private void turn(Loop loop, Node body, Parts parts, Heads heads, Label done) {
    parts.head(done);
    around.push(loop);
    Label start = to.beginRange();
    to.statement(body);
    Label end = to.code.newBoundLabel();
    around.pop();
    if (loop.handled()) {
      to.code.goto_(loop.next());
      Label handler = to.code.newBoundLabel();
      catchJumps(loop);
      to.code.exceptionCatch(start, end, handler, Names.CONTROL_FLOW);
    }
    to.code.labelBinding(loop.next());
    parts.step(heads);
  }

  /** {@code break} and {@code continue} that come as exceptions. */
  private void catchJumps(Loop loop) {
    int thrown = to.newObject();
    Label other = to.code.newLabel();
    to.code.astore(thrown);
    to.afterOthers();
    to.code.aload(thrown);
    to.help("isOfLoop", CD_boolean, Names.THROWABLE);
    to.code.ifeq(other).aload(thrown);
    to.help("isBreak", CD_boolean, Names.THROWABLE);
    to.code.ifeq(loop.next()).goto_(loop.broken());
    to.code.labelBinding(other);
    to.code.aload(thrown).athrow();
  }

  /** Emits the {@code ;} after a statement. */
  void yieldToOthers(Node after) {
    Label over = to.code.newLabel();
    yieldToOthers(after, over);
    to.code.labelBinding(over);
  }

  /**
   * Emits {@code ;}; jumps if there was nothing to do. Borrowing is seldom, and goes the way of
   * those that let others run, which the inner loop is better off without.
   */
  private void yieldToOthers(Node after, Label passed) {
    Label over = to.code.newLabel();
    if (isQuick()) {
      Label slow = crossings.next(after, to.taken());
      to.code.iload(to.passing()).ifle(slow).iinc(to.passing(), -1).goto_(passed);
      return;
    }
    if (to.isCounting()) {
      Label more = to.code.newLabel();
      Label none = to.code.newLabel();
      to.code.iload(to.passing()).ifle(more).iinc(to.passing(), -1).goto_(passed);
      to.code.labelBinding(more);
      if (copy == Copy.SLOW) {
        crossings.add(after, to.taken(), more);
      }
      to.yields();
      to.code.invokevirtual(Names.YIELDS, "borrow", MethodTypeDesc.of(CD_int));
      to.code.dup().istore(to.passing()).ifle(none).iinc(to.passing(), -1).goto_(over);
      to.code.labelBinding(none);
    } else {
      to.yields();
      to.code.invokevirtual(Names.YIELDS, "passes", MethodTypeDesc.of(CD_boolean)).ifne(passed);
    }
    to.letOthersRun();
    to.afterOthers();
    to.code.labelBinding(over);
  }

  // ------------------------------------------------------------------ leaving

  /** Emits {@code break} or {@code continue}. */
  void leave(boolean breaks) {
    Loop loop = around.getFirst();
    Label target = breaks ? loop.broken() : loop.next();
    to.tries().leave(around.size());
    to.scopes().leaveAll(around.size());
    // The Java machine verifies what follows, too.
    to.code.goto_(target);
  }

  /** Emits {@code return}. */
  void leaveFunction(Value value) {
    to.beforeOthers();
    to.tries().leave(0);
    for (Loop loop : around) {
      if (loop.jobs() >= 0) {
        end(loop, false);
      }
    }
    if (!to.isLoopUnit()) {
      to.answer(value);
      return;
    }
    to.scopes().leaveAll(0);
    to.writeAll();
    to.frame();
    to.help("returns", CD_void, Names.FRAME);
    to.load(value);
    to.code.areturn();
  }

  /** Emits the jump that the statement which has just been executed has asked for, if any. */
  void leaveIfAsked(Value value) {
    Label over = to.code.newLabel();
    to.frame();
    to.code.invokevirtual(Names.FRAME, "isLeaving", MethodTypeDesc.of(CD_boolean)).ifeq(over);
    @Nullable Loop loop = around.peek();
    if (loop != null) {
      Label leaves = to.code.newLabel();
      to.tries().leave(around.size());
      to.scopes().leaveAll(around.size());
      to.frame();
      to.help("leaving", CD_int, Names.FRAME);
      to.code.lookupswitch(
          loop.next(), List.of(SwitchCase.of(RETURN, leaves), SwitchCase.of(BREAK, loop.broken())));
      to.code.labelBinding(leaves);
    }
    leaveFunction(value);
    to.code.labelBinding(over);
  }
}
