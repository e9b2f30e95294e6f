package org.urbi.kernel.node;

import static java.util.Objects.requireNonNull;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** Composition of statements: {@code ;}, {@code |}, {@code ,} and {@code &}, scopes, {@code do}. */
public final class Sequences {
  private Sequences() {}

  /** Does nothing; void. */
  public static final class Noop extends Node {
    public Noop(Span span) {
      super(span);
    }

    @Override
    public UrbiObject execute(Frame frame) {
      return frame.interpreter.values().voidObject;
    }
  }

  /** Statements one after the other; its value is that of the last one. */
  public static final class Chain extends Node {
    private final Node[] statements;
    private final boolean[] yieldsAfter;

    /**
     * @param yieldsAfter whether others may run after each of the statements, of which there are
     *     two at least
     */
    public Chain(Span span, Node[] statements, boolean[] yieldsAfter) {
      super(span);
      this.statements = statements;
      this.yieldsAfter = yieldsAfter;
    }

    public Node[] statements() {
      return statements;
    }

    /** Whether others may run after the statement of that index; not to be asked for the last. */
    public boolean yieldsAfter(int index) {
      return yieldsAfter[index];
    }

    @Override
    void standsIn(@Nullable TurnCount loop) {
      for (Node statement : statements) {
        statement.standsIn(loop);
      }
    }

    @Override
    public UrbiObject execute(Frame frame) {
      // Whether a statement was the last one is asked behind it, and the first one is called in a
      // place of its own. Of a thousand jobs that wait in a statement the JVM would otherwise learn
      // that there is always another one, of the same kind, and would have to give up its code for
      // each job that goes on.
      int last = statements.length - 1;
      UrbiObject value = statements[0].execute(frame);
      for (int i = 1; ; i++) {
        if (frame.completion != null) {
          return value;
        }
        if (yieldsAfter[i - 1]) {
          frame.job.yield(frame, statements[i]);
        }
        value = statements[i].execute(frame);
        if (i == last) {
          return value;
        }
      }
    }
  }

  /** {@code a & b & c}: all at once, and waits for all. */
  public static final class Parallel extends Node {
    private final Node[] statements;

    public Parallel(Span span, Node[] statements) {
      super(span);
      this.statements = statements;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      try (Background group = new Background(frame.job)) {
        for (Node statement : statements) {
          group.start(frame, statement);
        }
        frame.job.at(frame, this);
        group.join();
      } catch (UrbiException e) {
        throw frame.located(e, span());
      }
      return frame.interpreter.values().voidObject;
    }
  }

  /** A statement followed by {@code ,}: it runs in the background of the surrounding scope. */
  public static final class Spawn extends Node {
    private final Node statement;

    public Spawn(Span span, Node statement) {
      super(span);
      this.statement = statement;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      requireNonNull(frame.background, "code with a comma has one around").start(frame, statement);
      frame.job.yield(frame, this);
      return frame.interpreter.values().voidObject;
    }
  }

  /** A scope with background statements, for which it waits at its end. */
  public static final class WithBackground extends Node {
    private final Node body;

    public WithBackground(Span span, Node body) {
      super(span);
      this.body = body;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      Background outer = frame.background;
      try (Background group = new Background(frame.job)) {
        frame.background = group;
        UrbiObject value = group.guard(() -> body.execute(frame));
        if (frame.completion == null) {
          frame.job.at(frame, this);
          group.join();
        }
        return value;
      } catch (UrbiException e) {
        throw frame.located(e, span());
      } finally {
        frame.background = outer;
      }
    }
  }

  /** Code with a source location of its own, which includes its braces. */
  public static final class Located extends Node {
    private final Node code;

    public Located(Span span, Node code) {
      super(span);
      this.code = code;
    }

    public Node code() {
      return code;
    }

    @Override
    void standsIn(@Nullable TurnCount loop) {
      code.standsIn(loop);
    }

    @Override
    public UrbiObject execute(Frame frame) {
      return code.execute(frame);
    }
  }

  /** {@code do (target) {…}}; its value is that of the body, or the target. */
  public static final class Do extends Node {
    private final Node target;
    private final Node body;

    public Do(Span span, Node target, Node body) {
      super(span);
      this.target = target;
      this.body = body;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject object = ArgumentEvaluation.notVoid(frame, target, span());
      Frame inner = frame.withSelf(object);
      inner.background = frame.background;
      UrbiObject value = body.execute(inner);
      if (inner.completion != null) {
        frame.completion = inner.completion;
        return value;
      }
      return object;
    }
  }
}
