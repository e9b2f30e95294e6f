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
    private int turns;
    private @Nullable CompiledCode compiled;

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

    @Override
    public UrbiObject execute(Frame frame) {
      LoopJobs jobs = LoopJobs.begin(frame);
      boolean broken = true;
      try {
        if (init != null) {
          init.execute(frame);
        }
        CodeCompiler compiler = frame.interpreter.compiler();
        while (compiled == null && (condition == null || condition.test(frame))) {
          if (++turns == compiler.threshold()) {
            compiled = compiler.loop(this, frame.locals.length);
          }
          UrbiObject value;
          try {
            value = body.execute(frame);
          } catch (NonLocalExit.Break leave) {
            return frame.interpreter.values().voidObject;
          } catch (NonLocalExit.Continue leave) {
            value = frame.interpreter.values().voidObject;
          }
          if (frame.completion != null) {
            if (frame.completion == Frame.Completion.RETURN) {
              broken = false;
              return value;
            }
            boolean over = frame.completion == Frame.Completion.BREAK;
            frame.completion = null;
            if (over) {
              return frame.interpreter.values().voidObject;
            }
          }
          if (step != null) {
            step.execute(frame);
          }
          if (yields) {
            frame.job.yield();
          } else {
            frame.job.checkInterrupted();
          }
        }
        UrbiObject value =
            compiled == null ? frame.interpreter.values().voidObject : compiled.execute(frame);
        broken = frame.completion == Frame.Completion.BREAK;
        if (broken) {
          frame.completion = null;
        }
        return value;
      } catch (RuntimeException e) {
        broken = false;
        throw e;
      } finally {
        jobs.end(frame, broken);
      }
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
            frame.job.yield();
            if (step != null) {
              step.execute(frame);
            }
          }
          return nothing;
        });
        group.join();
      } catch (NonLocalExit.Break leave) {
        // One of the turns has ended the whole loop.
      }
      return nothing;
    }
  }
}
