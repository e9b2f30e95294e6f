package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.ast.Ast.Flavor;
import org.urbi.lang.source.Span;

/** {@code loop}, {@code while} and the C-like {@code for}, in all their flavors. */
public final class Loops {
  private Loops() {}

  /** A loop whose turns come one after the other. */
  public static final class Sequential extends Node {
    private final @Nullable Node init;
    private final @Nullable Node condition;
    private final @Nullable Node step;
    private final Node body;
    private final boolean yields;
    private final TurnCount turns = new TurnCount();

    /**
     * @param init executed once before the loop, or null
     * @param condition null for an endless loop
     * @param step executed after each turn, or null
     */
    public Sequential(
        Span span,
        Flavor flavor,
        @Nullable Node init,
        @Nullable Node condition,
        @Nullable Node step,
        Node body) {
      super(span);
      this.init = init;
      this.condition = condition;
      this.step = step;
      this.body = body;
      this.yields = flavor == Flavor.SEMICOLON;
    }

    public @Nullable Node init() {
      return init;
    }

    /** Null for an endless loop. */
    public @Nullable Node condition() {
      return condition;
    }

    public @Nullable Node step() {
      return step;
    }

    public Node body() {
      return body;
    }

    /** Whether others may run after each turn. */
    public boolean yields() {
      return yields;
    }

    public TurnCount turns() {
      return turns;
    }

    @Override
    void standsIn(@Nullable TurnCount loop) {
      turns.standsIn(loop);
      body.standsIn(turns);
    }

    @Override
    public UrbiObject execute(Frame frame) {
      LoopJobs jobs = LoopJobs.begin(frame);
      boolean broken = false;
      try {
        if (init != null) {
          init.execute(frame);
        }
        CompiledCode compiled = turns.compiled(frame);
        UrbiObject value = compiled == null ? interpret(frame) : compiled.execute(frame);
        broken = frame.completion == Frame.Completion.BREAK;
        if (broken) {
          frame.completion = null;
        }
        return value;
      } finally {
        jobs.end(frame, broken);
      }
    }

    /** Executes the turns, until the loop is over or compiled. */
    private UrbiObject interpret(Frame frame) {
      CodeCompiler compiler = frame.interpreter.compiler();
      long limit = turns.limit(compiler);
      long turn = 0;
      try {
        while (condition == null || condition.test(frame)) {
          UrbiObject value = turn(frame);
          if (frame.completion != null) {
            if (frame.completion == Frame.Completion.RETURN) {
              return value;
            }
            if (frame.completion == Frame.Completion.BREAK) {
              return frame.interpreter.values().voidObject;
            }
            frame.completion = null;
          }
          if (step != null) {
            step.execute(frame);
          }
          if (yields) {
            frame.job.yield(frame, this);
          } else {
            frame.job.checkInterrupted();
          }
          if (++turn >= limit || turns.isWanted()) {
            CompiledCode compiled = turns.compile(this, frame, turn);
            if (compiled != null) {
              return compiled.execute(frame);
            }
            limit = turns.next(compiler, turn);
          }
        }
        return frame.interpreter.values().voidObject;
      } finally {
        turns.add(turn);
      }
    }

    private UrbiObject turn(Frame frame) {
      try {
        return body.execute(frame);
      } catch (NonLocalExit.Break leave) {
        frame.completion = Frame.Completion.BREAK;
      } catch (NonLocalExit.Continue leave) {
        frame.completion = Frame.Completion.CONTINUE;
      }
      return frame.interpreter.values().voidObject;
    }
  }

  /** A loop whose turns run in the background, all at once. */
  public static final class Concurrent extends Node {
    private final @Nullable Node init;
    private final @Nullable Node condition;
    private final @Nullable Node step;
    private final Node body;

    /** The parameters are those of {@link Sequential}. */
    public Concurrent(
        Span span, @Nullable Node init, @Nullable Node condition, @Nullable Node step, Node body) {
      super(span);
      this.init = init;
      this.condition = condition;
      this.step = step;
      this.body = body;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject nothing = frame.interpreter.values().voidObject;
      try (Background group = new Background(frame.job)) {
        group.guard(() -> {
          if (init != null) {
            init.execute(frame);
          }
          while (condition == null || condition.test(frame)) {
            group.start(frame, body);
            frame.job.yield(frame, this);
            if (step != null) {
              step.execute(frame);
            }
          }
          return nothing;
        });
        frame.job.at(frame, this);
        group.join();
      } catch (NonLocalExit.Break leave) {
        // One of the turns has ended the whole loop.
      }
      return nothing;
    }
  }
}
