package org.urbi.kernel.node;

import java.util.ArrayList;
import java.util.List;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** The actions that run when a scope is left, in whatever way (manual, "Scope tags"). */
public final class ScopeEnd {
  private final List<Runnable> actions = new ArrayList<>(1);

  /** Adds an action; actions run in the order in which they were added. */
  public void add(Runnable action) {
    actions.add(action);
  }

  void run() {
    actions.forEach(Runnable::run);
  }

  /** A scope whose code may add actions for its end. */
  public static final class Marked extends Node {
    private final Node body;

    public Marked(Span span, Node body) {
      super(span);
      this.body = body;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      ScopeEnd outer = frame.scopeEnd;
      ScopeEnd end = new ScopeEnd();
      frame.scopeEnd = end;
      try {
        return body.execute(frame);
      } finally {
        frame.scopeEnd = outer;
        end.run();
      }
    }
  }
}
