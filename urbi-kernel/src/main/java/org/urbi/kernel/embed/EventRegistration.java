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
final class EventRegistration implements Subscription {
  private final Embedding embedding;
  private final int number;
  private final String expression;
  private final ListenerQueue<List<Object>> queue;

  /**
   * @param number of the request, by which it is ended
   */
  EventRegistration(
      Embedding embedding, int number, String expression, Consumer<? super List<Object>> listener) {
    this.embedding = embedding;
    this.number = number;
    this.expression = expression;
    this.queue = new ListenerQueue<>(embedding.scheduler(), listener);
  }

  /** Subscribes to the event, or the object that can be converted to one; in a job. */
  ListenerRegistration run(Frame frame) {
    UrbiEvent event =
        subscribe(frame, Evaluation.eval(frame, null, frame.self(), expression, null));
    return listening(() -> event.unsubscribe(this));
  }

  /** Subscribes to an event, or to an object that can be converted to one. */
  UrbiEvent subscribe(Frame frame, UrbiObject source) {
    UrbiEvent event = event(frame, source);
    event.subscribe(this, frame.job());
    return event;
  }

  /**
   * The registration for the program, once the event is subscribed.
   *
   * @param end ends what the subscription is for; on the kernel thread
   */
  ListenerRegistration listening(Runnable end) {
    return embedding.listening(number, queue::close, end);
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
