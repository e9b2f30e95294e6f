package org.urbi.kernel.embed;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Consumer;
import org.urbi.kernel.event.Emission;
import org.urbi.kernel.event.Subscription;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.library.system.Evaluation;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;

/** A subscription to an event (manual, "Event"); the listener gets the payload of each emission. */
final class EventRegistration implements Embedding.Task<ListenerRegistration>, Subscription {
  private final Embedding embedding;
  private final String expression;
  private final ListenerQueue<List<Object>> queue;

  EventRegistration(
      Embedding embedding, String expression, Consumer<? super List<Object>> listener) {
    this.embedding = embedding;
    this.expression = expression;
    this.queue = new ListenerQueue<>(embedding.scheduler(), listener);
  }

  @Override
  public ListenerRegistration run(Frame frame) {
    return subscribe(frame, Evaluation.eval(frame, null, frame.self(), expression, null));
  }

  /** Subscribes to an event, or to an object that can be converted to one. */
  ListenerRegistration subscribe(Frame frame, UrbiObject source) {
    UrbiEvent event = event(frame, source);
    event.subscribe(this, frame.job());
    return embedding.listening(queue::close, () -> event.unsubscribe(this));
  }

  private static UrbiEvent event(Frame frame, UrbiObject value) {
    if (value instanceof UrbiEvent event) {
      return event;
    }
    Interpreter interpreter = frame.interpreter();
    if (value.lookup(interpreter.world().symbol("asEvent")) != null
        && interpreter.send(frame, value, "asEvent") instanceof UrbiEvent event) {
      return event;
    }
    throw interpreter.errors().argumentType("onEvent", 1, value, interpreter.prototypes().event);
  }

  @Override
  public void begin(Emission emission, Job emitter) {
    List<Object> payload = new ArrayList<>();
    for (UrbiObject value : emission.payload()) {
      payload.add(JavaValues.toJava(embedding, value));
    }
    queue.post(Collections.unmodifiableList(payload));
  }

  @Override
  public void end(Emission emission, Job emitter) {}
}
