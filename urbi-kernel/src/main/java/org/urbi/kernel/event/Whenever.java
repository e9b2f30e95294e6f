package org.urbi.kernel.event;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.Timers;
import org.urbi.kernel.node.ForkedCode;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/**
 * {@code whenever (condition) body else elseClause}: executes the body again and again as long as
 * the condition holds, and the {@code else} clause as long as it does not.
 */
public final class Whenever extends Node {
  private final Condition condition;
  private final @Nullable Node duration;
  private final Node body;
  private final @Nullable Node elseClause;

  /**
   * @param duration how long it must hold, or null
   * @param elseClause may be null
   */
  public Whenever(
      Span span,
      Condition condition,
      @Nullable Node duration,
      Node body,
      @Nullable Node elseClause) {
    super(span);
    this.condition = condition;
    this.duration = duration;
    this.body = body;
    this.elseClause = elseClause;
  }

  @Override
  public UrbiObject execute(Frame frame) {
    long hold = Durations.nanoseconds(frame, duration);
    Frame home = frame.fork(frame.job(), false);
    if (condition instanceof Condition.WhenEmitted emitted) {
      var armed = new OnEvent(home, emitted, EventLookup.event(frame, emitted.event()), hold);
      armed.scope.add(armed);
      armed.otherwise();
      armed.source.subscribe(armed, frame.job());
    } else {
      Condition.WhenTrue holds = (Condition.WhenTrue) condition;
      var armed = new OnExpression(home, holds.expression(), hold);
      armed.scope.add(armed);
      armed.watch.begin(frame.job(), () -> armed.stopped(null));
    }
    return frame.interpreter().values().voidObject;
  }

  /**
   * The common part of both kinds: repeats a clause in a job as long as its condition asks for it.
   */
  private abstract class Repeating implements Reaction {
    final Frame home;
    final TagScope scope;
    final UrbiObject lobby;
    private final Occurrences occurrences = new Occurrences();
    boolean stopped;

    Repeating(Frame home) {
      this.home = home;
      this.scope = home.job().scopeForNew();
      this.lobby = home.job().lobby();
    }

    /** Repeats a clause in a job of its own as long as the supplier returns true. */
    void repeat(Frame variables, Node clause, BooleanSupplier goesOn) {
      var code =
          new ForkedCode(frame -> {
            while (!stopped && goesOn.getAsBoolean()) {
              occurrences.note(frame.job().scheduler().now());
              clause.execute(frame);
              // Let others run, as a loop of the condition and the clause, separated by ";", would.
              frame.job().yieldNow();
              frame.job().yieldNow();
            }
          });
      // Of simultaneous emissions, the last one is handled first.
      Job job = home.job().scheduler().startAhead(lobby, scope, "whenever", code);
      code.runWith(variables.fork(job, false));
    }

    Facts facts(@Nullable UrbiEvent event) {
      return new Facts("whenever", span(), scope, lobby, occurrences, event);
    }
  }

  /** On an expression. */
  private final class OnExpression extends Repeating implements ExpressionWatcher.Listener {
    private final Node expression;
    private final ExpressionWatcher watch;
    private final long hold;
    private boolean known;
    private boolean holds;
    private long turn;
    private Timers.@Nullable Timer timer;

    OnExpression(Frame home, Node expression, long hold) {
      super(home);
      this.expression = expression;
      this.hold = hold;
      this.watch = new ExpressionWatcher(home, expression, this);
    }

    @Override
    public void evaluated(UrbiObject value, Job evaluator) {
      boolean now;
      try {
        now = Truth.of(home.in(evaluator), value);
      } catch (UrbiException e) {
        throw home.located(e, expression.span());
      }
      if (known && now == holds) {
        return;
      }
      known = true;
      holds = now;
      if (timer != null) {
        timer.cancel();
        timer = null;
      }
      if (holds && hold > 0) {
        var scheduler = evaluator.scheduler();
        timer = scheduler.timers().add(scheduler.now() + hold, this::begin);
      } else {
        begin();
      }
    }

    private void begin() {
      long mine = ++turn;
      Node clause = holds ? body : elseClause;
      if (clause != null) {
        repeat(home, clause, () -> turn == mine);
      }
    }

    @Override
    public Facts facts() {
      return facts(null);
    }

    @Override
    public List<String> read(int most) {
      return watch.read(most);
    }

    @Override
    public void stopped(@Nullable TagScope by) {
      stopped = true;
      watch.close();
      if (timer != null) {
        timer.cancel();
      }
      scope.remove(this);
    }
  }

  /** On an event. */
  private final class OnEvent extends Repeating implements Subscription {
    private final String name;
    private final UrbiEvent source;
    private final EventFilter filter;
    private final long hold;
    private final Map<Emission, Timers.Timer> accepted = new IdentityHashMap<>();
    private long turn;

    OnEvent(Frame home, Condition.WhenEmitted condition, UrbiEvent source, long hold) {
      super(home);
      this.name = condition.event().span().text();
      this.filter = condition.filter();
      this.source = source;
      this.hold = hold;
    }

    @Override
    public void begin(Emission emission, Job emitter) {
      if (scope.isSilent()) {
        return;
      }
      Frame matched = home.fork(emitter, false);
      if (!emitter.identity().doFor(lobby, () -> filter.accepts(matched, emission.payload()))) {
        return;
      }
      turn++;
      if (hold == 0) {
        accepted.put(emission, null);
        run(emission, matched);
      } else {
        var scheduler = emitter.scheduler();
        accepted.put(
            emission, scheduler.timers().add(scheduler.now() + hold, () -> run(emission, matched)));
      }
    }

    private void run(Emission emission, Frame matched) {
      // Run it at least once, even for an emission without duration.
      boolean[] first = {true};
      repeat(
          matched,
          body,
          () -> {
            boolean goesOn = first[0] || !emission.isOver();
            first[0] = false;
            return goesOn;
          });
    }

    @Override
    public void end(Emission emission, Job emitter) {
      if (accepted.containsKey(emission)) {
        Timers.Timer timer = accepted.remove(emission);
        if (timer != null) {
          timer.cancel();
        }
        if (accepted.isEmpty()) {
          otherwise();
        }
      }
    }

    void otherwise() {
      if (elseClause != null) {
        long mine = ++turn;
        repeat(home, elseClause, () -> turn == mine);
      }
    }

    @Override
    public Facts facts() {
      return facts(source);
    }

    @Override
    public List<String> read(int most) {
      return List.of(name);
    }

    @Override
    public void stopped(@Nullable TagScope by) {
      stopped = true;
      source.unsubscribe(this);
      scope.remove(this);
    }
  }
}
