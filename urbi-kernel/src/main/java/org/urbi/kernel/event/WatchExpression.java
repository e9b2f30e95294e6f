package org.urbi.kernel.event;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** {@code watch(expression)}: an event emitted with each new value of the expression. */
public final class WatchExpression extends Node {
  private final Node expression;

  public WatchExpression(Span span, Node expression) {
    super(span);
    this.expression = expression;
  }

  @Override
  public UrbiObject execute(Frame frame) {
    UrbiEvent event = (UrbiEvent) frame.interpreter().prototypes().event.cloned();
    Watching watching = new Watching(frame.fork(frame.job(), false), event);
    watching.watch.begin(frame.job(), watching.watch::close);
    watching.scope.add(watching);
    return event;
  }

  /** A {@code watch} that has been executed. */
  private final class Watching implements ExpressionWatcher.Listener, Reaction {
    private final UrbiEvent event;
    private final TagScope scope;
    private final UrbiObject lobby;
    private final ExpressionWatcher watch;
    private final Occurrences occurrences = new Occurrences();

    Watching(Frame home, UrbiEvent event) {
      this.event = event;
      scope = home.job().scopeForNew();
      lobby = home.job().lobby();
      watch = new ExpressionWatcher(home, expression, this);
    }

    @Override
    public void evaluated(UrbiObject value, Job evaluator) {
      occurrences.note(evaluator.scheduler().now());
      event.emit(evaluator, false, value);
    }

    @Override
    public Facts facts() {
      return new Facts("watch", span(), scope, lobby, occurrences, event);
    }

    @Override
    public List<String> read(int most) {
      return watch.read(most);
    }

    @Override
    public void stopped(@Nullable TagScope by) {
      watch.close();
      scope.remove(this);
    }
  }
}
