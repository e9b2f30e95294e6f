package org.urbi.kernel.event;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;

/** Functions that are called when an event is emitted, and when the emission is over. */
public final class FunctionHandler implements Subscription, Reaction {
  /** An emission that the guard has accepted, with what the functions are called with. */
  record Matched(UrbiObject[] arguments) implements EmissionNote {}

  private final UrbiEvent event;
  private final Frame home;
  private final TagScope scope;
  private final UrbiObject lobby;
  private final @Nullable UrbiObject guard;
  private final UrbiObject enter;
  private final @Nullable UrbiObject leave;
  private final boolean sync;
  private final Occurrences occurrences = new Occurrences();
  private boolean stopped;

  private FunctionHandler(
      Frame home,
      UrbiEvent event,
      @Nullable UrbiObject guard,
      UrbiObject enter,
      @Nullable UrbiObject leave,
      boolean sync) {
    this.event = event;
    this.home = home;
    this.scope = home.job().scopeForNew();
    this.lobby = home.job().lobby();
    this.guard = guard;
    this.enter = enter;
    this.leave = leave;
    this.sync = sync;
    scope.add(this);
  }

  /**
   * The handler that {@code onEvent} installs (Urbi 3, "Event"): its functions are called with the
   * event and the list of its payload; {@code enter} and {@code leave} also get the result of the
   * guard.
   *
   * @param guard accepts an emission, unless it returns void
   * @param leave called when the emission is over; may be null
   * @param sync whether the emitting job calls the functions; if not, they run in jobs of their own
   */
  public static FunctionHandler guarded(
      Frame home,
      UrbiEvent event,
      UrbiObject guard,
      UrbiObject enter,
      @Nullable UrbiObject leave,
      boolean sync) {
    return new FunctionHandler(home, event, guard, enter, leave, sync);
  }

  /** A function that the emitting job calls with the payload of the event. */
  public static FunctionHandler plain(Frame home, UrbiEvent event, UrbiObject function) {
    return new FunctionHandler(home, event, null, function, null, true);
  }

  @Override
  public void begin(Emission emission, Job emitter) {
    if (scope.isSilent()) {
      return;
    }
    if (guard == null) {
      occurrences.note(emitter.scheduler().now());
      call(emitter, enter, emission.payload());
      return;
    }
    Values values = home.interpreter().values();
    UrbiObject payload = values.list(List.of(emission.payload()));
    UrbiObject matched = call(emitter, guard, event, payload);
    if (matched == values.voidObject) {
      return;
    }
    UrbiObject[] arguments = {event, payload, matched};
    if (leave != null) {
      emission.note(this, new Matched(arguments));
    }
    occurrences.note(emitter.scheduler().now());
    run(emission, emitter, enter, arguments);
  }

  @Override
  public void end(Emission emission, Job emitter) {
    if (leave != null && !stopped && emission.noted(this) instanceof Matched matched) {
      run(emission, emitter, leave, matched.arguments);
    }
  }

  private void run(Emission emission, Job emitter, UrbiObject function, UrbiObject[] arguments) {
    if (sync || emission.isSync()) {
      call(emitter, function, arguments);
      return;
    }
    emitter.scheduler().startDetached(lobby, scope, "at", job -> call(job, function, arguments));
  }

  private UrbiObject call(Job job, UrbiObject function, UrbiObject... arguments) {
    return job.identity()
        .doFor(
            lobby, () -> home.interpreter().call(home.in(job), function, home.self(), arguments));
  }

  @Override
  public Facts facts() {
    return new Facts("onEvent", null, scope, lobby, occurrences, event);
  }

  @Override
  public void stopped(@Nullable TagScope by) {
    stopped = true;
    event.unsubscribe(this);
    scope.remove(this);
  }
}
