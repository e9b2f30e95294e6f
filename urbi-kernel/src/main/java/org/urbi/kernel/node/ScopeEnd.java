package org.urbi.kernel.node;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiObject;

/**
 * What is done when a scope, or the code of a function, is left in whatever way (manual, "Scope
 * tags").
 *
 * <p>Most scopes are left without anything to do, so a scope gets its end when something is added:
 * the innermost one that is left from then on has to do it. Only where the code around has an end
 * already a scope gets its own when it is entered.
 */
public final class ScopeEnd {
  /** Stands for the end of the top level, which is never left. */
  static final ScopeEnd NEVER = new ScopeEnd(null);

  /** What compiled code has instead of the answer of {@link #enter} until it enters a scope. */
  public static final ScopeEnd NOT_ENTERED = new ScopeEnd(null);

  /** The end of a scope around, of the same function; null if none has one. */
  private final @Nullable ScopeEnd outer;

  private List<Runnable> first = List.of();
  private List<Runnable> last = List.of();
  private boolean over;

  ScopeEnd(@Nullable ScopeEnd outer) {
    this.outer = outer;
  }

  /**
   * Adds an action that runs when the code is over, even if it waits for jobs in the background.
   */
  public void add(Runnable action) {
    first = with(action, first);
  }

  /** Adds an action that runs when such jobs have ended, too. */
  public void addLast(Runnable action) {
    last = with(action, last);
  }

  /** What a job adds that has outlived the scope is dropped: nobody would run it. */
  private List<Runnable> with(Runnable action, List<Runnable> actions) {
    if (over) {
      return List.of();
    }
    List<Runnable> all = actions.isEmpty() ? new ArrayList<>(1) : actions;
    all.add(action);
    return all;
  }

  /** The code of the scope is over. */
  private void codeOver() {
    List<Runnable> actions = first;
    first = List.of();
    actions.forEach(Runnable::run);
  }

  private void run() {
    try {
      codeOver();
    } finally {
      over = true;
      last.forEach(Runnable::run);
      last = List.of();
    }
  }

  /**
   * A scope is entered.
   *
   * @param frame null if nobody has needed it until now
   * @return what is to be told to {@link #leave}
   */
  static @Nullable ScopeEnd enter(@Nullable Frame frame) {
    return frame == null || frame.scopeEnd == null ? null : begin(frame, frame.scopeEnd);
  }

  private static ScopeEnd begin(Frame frame, ScopeEnd around) {
    frame.scopeEnd = around == NEVER ? null : new ScopeEnd(around);
    return around;
  }

  /**
   * A scope is left: what was added in it is done, the innermost scope first.
   *
   * @param frame null if nobody has needed it until now
   * @param around what {@link #enter} has answered; null for a function
   */
  static void leave(@Nullable Frame frame, @Nullable ScopeEnd around) {
    if (frame != null && frame.scopeEnd != around) {
      end(frame, around);
    }
  }

  private static void end(Frame frame, @Nullable ScopeEnd around) {
    ScopeEnd end = frame.scopeEnd;
    frame.scopeEnd = around;
    for (; end != null && end != around; end = end.outer) {
      end.run();
    }
  }

  /** A scope. */
  public static final class Scope extends Node {
    private final Node body;

    public Scope(Node body) {
      super(body.span());
      this.body = body;
    }

    public Node body() {
      return body;
    }

    @Override
    void standsIn(@Nullable TurnCount loop) {
      body.standsIn(loop);
    }

    @Override
    public UrbiObject execute(Frame frame) {
      ScopeEnd around = enter(frame);
      try {
        return body.execute(frame);
      } finally {
        leave(frame, around);
      }
    }
  }

  /** The code of a scope that waits afterwards for its jobs in the background. */
  public static final class BeforeBackground extends Node {
    private final Node body;

    public BeforeBackground(Node body) {
      super(body.span());
      this.body = body;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      try {
        return body.execute(frame);
      } finally {
        if (frame.scopeEnd != null) {
          frame.scopeEnd.codeOver();
        }
      }
    }
  }
}
