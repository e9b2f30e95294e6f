package org.urbi.kernel.embed;

import java.util.function.Consumer;
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
final class ChangeRegistration implements Embedding.Task<ListenerRegistration> {
  private final Embedding embedding;
  private final String expression;
  private final Consumer<Object> listener;

  ChangeRegistration(Embedding embedding, String expression, Consumer<Object> listener) {
    this.embedding = embedding;
    this.expression = expression;
    this.listener = listener;
  }

  @Override
  public ListenerRegistration run(Frame frame) {
    Interpreter interpreter = frame.interpreter();
    ParseResult parsed = UrbiParser.parse(expression, null);
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
    var events =
        new EventRegistration(
            embedding, expression, payload -> listener.accept(payload.getFirst()));
    ListenerRegistration listening = events.subscribe(frame, changes);
    return embedding.listening(listening::close, () -> tag.stop(interpreter.values().voidObject));
  }
}
