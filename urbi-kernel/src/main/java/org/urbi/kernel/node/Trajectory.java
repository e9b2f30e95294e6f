package org.urbi.kernel.node;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.SlotData;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/**
 * {@code x = target time: 5s}: passes functions that read and write the variable, and the
 * attributes, to {@code TrajectoryGenerator} (manual, "TrajectoryGenerator").
 */
public final class Trajectory extends Node implements CallSite {
  /** The properties of the slot that limit its motions. */
  private static final List<String> LIMITS = List.of("speedmin", "speedmax", "delta");

  private final Node variable;
  private final @Nullable Slot slot;
  private final Variables.Place written;
  private final Node write;
  private final Node target;
  private final String[] names;
  private final Node[] values;

  /**
   * The slot that is moved.
   *
   * @param owner the object that has the slot
   */
  public record Slot(Node owner, Symbol name) {}

  /**
   * @param variable reads the variable
   * @param slot the slot that is moved; null if it is another variable
   * @param written the local variable that receives the next value before {@code write} is executed
   * @param write assigns that value
   */
  public Trajectory(
      Span span,
      Node variable,
      @Nullable Slot slot,
      Variables.Place written,
      Node write,
      Node target,
      String[] names,
      Node[] values) {
    super(span);
    this.variable = variable;
    this.slot = slot;
    this.written = written;
    this.write = write;
    this.target = target;
    this.names = names;
    this.values = values;
  }

  @Override
  public String calledName() {
    return "TrajectoryGenerator";
  }

  @Override
  public Span calledSpan() {
    return span();
  }

  @Override
  public UrbiObject execute(Frame frame) {
    Interpreter interpreter = frame.interpreter;
    Map<UrbiDictionary.Key, UrbiObject> attributes = new LinkedHashMap<>();
    // Reading the variable first reports a missing one at its location.
    variable.execute(frame);
    SlotData data = data(frame);
    if (data != null) {
      for (String property : LIMITS) {
        UrbiObject limit = data.property(property);
        if (limit != null) {
          attributes.put(DictionaryKey.of(frame, interpreter.values().string(property)), limit);
        }
      }
    }
    for (int i = 0; i < names.length; i++) {
      attributes.put(
          DictionaryKey.of(frame, interpreter.values().string(names[i])),
          ArgumentEvaluation.notVoid(frame, values[i], span()));
    }
    UrbiObject goal = target.execute(frame);
    if (goal instanceof UrbiFloat number && Double.isNaN(number.value())) {
      goal = interpreter.values().number(0);
    }
    UrbiObject end = goal;
    return data != null && data.blending() instanceof Blending blending
        ? blending.move(frame, () -> follow(frame, end, attributes))
        : follow(frame, end, attributes);
  }

  /** The properties of the slot, or null. */
  private @Nullable SlotData data(Frame frame) {
    if (slot == null) {
      return null;
    }
    UrbiObject holder = slot.owner.execute(frame).locate(slot.name);
    return holder == null ? null : holder.slotData(slot.name);
  }

  private UrbiObject follow(
      Frame frame, UrbiObject goal, Map<UrbiDictionary.Key, UrbiObject> attributes) {
    Interpreter interpreter = frame.interpreter;
    Shape code = interpreter.prototypes.codeShape;
    UrbiObject generator =
        interpreter.get(frame, frame.self, interpreter.world().symbol("TrajectoryGenerator"));
    try {
      return interpreter.send(
          frame,
          this,
          generator,
          interpreter.world().symbol("follow"),
          new Accessor(code, frame, false),
          new Accessor(code, frame, true),
          goal,
          interpreter.values().dictionary(attributes));
    } catch (UrbiException e) {
      throw frame.located(e, span());
    }
  }

  /** The variable, as a function that reads or writes it. */
  private final class Accessor extends Code {
    private final Frame home;
    private final UrbiObject lobby;
    private final boolean writes;

    Accessor(Shape shape, Frame home, boolean writes) {
      super(shape);
      this.home = home;
      this.lobby = home.job.lobby();
      this.writes = writes;
    }

    @Override
    public boolean isLazy() {
      return false;
    }

    @Override
    public UrbiObject call(Frame caller, CallSite site, UrbiObject self, UrbiObject... arguments) {
      Frame frame = home.in(caller.job);
      if (!writes) {
        return caller.job.identity().doFor(lobby, () -> variable.execute(frame));
      }
      written.declare(frame, arguments[0]);
      return caller.job.identity().doFor(lobby, () -> write.execute(frame));
    }
  }
}
