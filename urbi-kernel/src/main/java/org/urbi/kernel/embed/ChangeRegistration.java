package org.urbi.kernel.embed;

import org.urbi.kernel.compile.Compilation;
import org.urbi.kernel.event.WatchExpression;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.TagState;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.tag.UrbiTag;
import org.urbi.lang.parse.ParseResult;
import org.urbi.lang.parse.UrbiParser;

/** A {@code watch} of an expression (manual, "watch"); each new value is passed to the listener. */
final class ChangeRegistration {
  private final EventRegistration events;
  private final String expression;

  /**
   * @param events whose event is that of the changes
   */
  ChangeRegistration(EventRegistration events, String expression) {
    this.events = events;
    this.expression = expression;
  }

  /** Begins to watch; in a job. */
  ListenerRegistration run(Frame frame) {
    Interpreter interpreter = frame.interpreter();
    ParseResult parsed = UrbiParser.parse(expression, null, frame.job()::checkInterrupted);
    if (!parsed.errors().isEmpty()) {
      throw interpreter.errors().syntax(parsed.errors().getFirst(), expression);
    }
    var compiled = Compilation.compile(interpreter, parsed.sequence());
    var watch = new WatchExpression(parsed.sequence().span(), compiled.code());
    // Stopping this tag ends the watch.
    TagState tag = ((UrbiTag) interpreter.prototypes().tag.cloned()).state();
    TagScope scope = frame.job().enter(tag);
    UrbiObject changes;
    try {
      changes = watch.execute(frame.nested(null, frame.self(), compiled.layout()));
    } finally {
      frame.job().leave(scope);
    }
    events.subscribe(frame, changes);
    return events.listening(
        () -> tag.stop(interpreter.scheduler(), interpreter.values().voidObject));
  }
}
