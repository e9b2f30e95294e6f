package org.urbi.kernel.tag;

import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.event.Durations;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagState;
import org.urbi.kernel.job.Timers;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Variables;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** Code under a tag of its own, which a timeout or a watchdog stops or freezes. */
public final class ConditionalTag {
  private ConditionalTag() {}

  /** Executes code without a value, unless a {@code return} leaves it with one. */
  private static UrbiObject valueless(Frame frame, UrbiObject value) {
    return frame.isLeaving() ? value : frame.interpreter().values().voidObject;
  }

  /** {@code timeout (duration) body}. */
  public static final class Timeout extends Node {
    private final Node duration;
    private final Node body;

    public Timeout(Span span, Node duration, Node body) {
      super(span);
      this.duration = duration;
      this.body = body;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject seconds = duration.execute(frame);
      if (!(seconds instanceof UrbiFloat number)) {
        var interpreter = frame.interpreter();
        throw frame.located(
            interpreter
                .errors()
                .argumentType("timeout", 1, seconds, interpreter.values().floatProto),
            duration.span());
      }
      var nothing = frame.interpreter().values().voidObject;
      UrbiTag tag = (UrbiTag) frame.interpreter().prototypes().tag.cloned();
      var scheduler = frame.job().scheduler();
      Timers.Timer timer =
          scheduler
              .timers()
              .add(
                  scheduler.now() + Durations.nanoseconds(number.value()),
                  () -> tag.state().stop(scheduler, nothing));
      try {
        return valueless(frame, Tagged.run(frame, tag, body));
      } finally {
        timer.cancel();
      }
    }
  }

  /** {@code stopif (condition) body}, {@code freezeif (condition) body}. */
  public static final class StopOrFreezeIf extends Node {
    private final Variables.Place place;
    private final Node watchdog;
    private final Node body;

    /**
     * @param place the variable that holds the tag of the body for the watchdog
     * @param watchdog an {@code at} which controls that tag
     */
    public StopOrFreezeIf(Span span, Variables.Place place, Node watchdog, Node body) {
      super(span);
      this.place = place;
      this.watchdog = watchdog;
      this.body = body;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      var control = new Controlled(frame.interpreter().prototypes().tag.cloneShape());
      UrbiTag around = (UrbiTag) frame.interpreter().prototypes().tag.cloned();
      place.declare(frame, control);
      Node armed =
          new Node(span()) {
            @Override
            public UrbiObject execute(Frame inner) {
              watchdog.execute(inner);
              control.begin(inner);
              try {
                return Tagged.run(inner, control, body);
              } finally {
                around.state().dismiss();
              }
            }
          };
      return valueless(frame, Tagged.run(frame, around, armed));
    }
  }

  /**
   * The tag of the body. If the condition holds before the body has begun, the action of the
   * watchdog is delayed until the body lets others run for the first time.
   */
  private static final class Controlled extends UrbiTag {
    private boolean begun;
    private @Nullable Consumer<TagState> wanted;

    Controlled(Shape shape) {
      super(shape);
    }

    void control(Consumer<TagState> action) {
      if (begun) {
        action.accept(state());
      } else {
        wanted = action;
      }
    }

    void begin(Frame frame) {
      Consumer<TagState> action = wanted;
      if (action == null) {
        begun = true;
      } else {
        Job job = frame.job();
        job.scheduler()
            .startDetached(
                job.lobby(),
                job.scopeForNew(),
                "stopif",
                started -> {
                  begun = true;
                  action.accept(state());
                });
      }
    }
  }

  /** The action of the watchdog on the tag. */
  public static final class Control extends Node {
    private final Node tag;
    private final Consumer<TagState> action;

    public Control(Span span, Node tag, Consumer<TagState> action) {
      super(span);
      this.tag = tag;
      this.action = action;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      ((Controlled) tag.execute(frame)).control(action);
      return frame.interpreter().values().voidObject;
    }
  }
}
