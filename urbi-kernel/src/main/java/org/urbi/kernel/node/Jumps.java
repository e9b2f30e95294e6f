package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** {@code return}, {@code break}, {@code continue}, {@code throw}. */
public final class Jumps {
  private Jumps() {}

  /** {@code return value}. */
  public static final class Return extends Node {
    private final @Nullable Node value;
    private final boolean inClosure;
    private final boolean seen;

    /**
     * @param value null for void
     * @param inClosure whether it is in a closure, and so leaves the function around that closure
     * @param seen whether the surrounding statements check how this one ended; if not, an exception
     *     is thrown
     */
    public Return(Span span, @Nullable Node value, boolean inClosure, boolean seen) {
      super(span);
      this.value = value;
      this.inClosure = inClosure;
      this.seen = seen;
    }

    /** The value; null for void. */
    public @Nullable Node value() {
      return value;
    }

    /** Whether it ends the function in which it stands, as the statements around it check. */
    public boolean isPlain() {
      return seen && !inClosure;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject result =
          value == null ? frame.interpreter.values().voidObject : value.execute(frame);
      Frame home = inClosure ? frame.home() : null;
      if (home != null && frame.isCalledWithin(home)) {
        throw new NonLocalExit.Return(home, result);
      }
      if (!seen) {
        throw new NonLocalExit.Return(frame.activation, result);
      }
      frame.completion = Frame.Completion.RETURN;
      return result;
    }
  }

  /** {@code break} and {@code continue}. */
  public static final class OfLoop extends Node {
    private final boolean over;
    private final boolean seen;

    /**
     * @param over true for {@code break}
     * @param seen whether the statements around see how this one ended; otherwise it is thrown
     */
    public OfLoop(Span span, boolean over, boolean seen) {
      super(span);
      this.over = over;
      this.seen = seen;
    }

    /** Whether it is {@code break}. */
    public boolean isBreak() {
      return over;
    }

    /** Whether the statements around check for it. */
    public boolean isPlain() {
      return seen;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      if (!seen) {
        throw over ? new NonLocalExit.Break() : new NonLocalExit.Continue();
      }
      frame.completion = over ? Frame.Completion.BREAK : Frame.Completion.CONTINUE;
      return frame.interpreter.values().voidObject;
    }
  }

  /** {@code throw value}, or {@code throw} alone, which rethrows what was caught. */
  public static final class Throw extends Node {
    private final @Nullable Node value;

    /**
     * @param value null to rethrow
     */
    public Throw(Span span, @Nullable Node value) {
      super(span);
      this.value = value;
    }

    /** The value; null to rethrow. */
    public @Nullable Node value() {
      return value;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      throw value == null ? caught(frame) : thrown(frame, value.execute(frame));
    }

    /** The exception with that value. */
    UrbiException thrown(Frame frame, UrbiObject what) {
      return frame.located(new UrbiException(what), span());
    }

    /** The exception that is thrown again. */
    UrbiException caught(Frame frame) {
      return frame.caught == null
          ? frame.located(frame.interpreter.errors().scheduling(Problem.NOTHING_CAUGHT), span())
          : frame.caught;
    }
  }
}
