package org.urbi.kernel.event;

import org.jspecify.annotations.Nullable;
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
    Frame home = frame.fork(frame.job(), false);
    ExpressionWatcher watch =
        new ExpressionWatcher(
            home, expression, (value, evaluator) -> event.emit(evaluator, false, value));
    boolean ready = false;
    try {
      watch.begin(frame.job());
      ready = true;
    } finally {
      if (!ready) {
        watch.close();
      }
    }
    TagScope scope = frame.job().scope();
    scope.add(
        new TagScope.Attachment() {
          @Override
          public void stopped(@Nullable TagScope by) {
            watch.close();
            scope.remove(this);
          }
        });
    return event;
  }
}
