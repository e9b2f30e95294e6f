package org.urbi.kernel.uobject;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.journal.LooseReference;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Properties;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.variable.Datum;
import org.urbi.kernel.variable.UrbiUVar;
import urbi.UCallback;
import urbi.UDataType;
import urbi.UObject;
import urbi.UProperty;
import urbi.USlot;
import urbi.UValue;

/** A variable of urbiscript, as used by a module in the kernel's process. */
final class PluggedSlot implements USlot {
  private static final double NANOSECONDS_PER_MICROSECOND = 1000;

  private final PluggedContext context;
  private final KernelCrossing crossing;

  /** The variable, which leads to the object that keeps it, if one does. */
  private final LooseReference<UrbiUVar> reference;

  /** The variable, if nobody else keeps it. */
  private @Nullable UrbiUVar kept;

  private final String name;
  private final int number;
  private final List<Runnable> notifications = new ArrayList<>(1);
  private volatile boolean owner;
  private volatile boolean bypass;
  private double lastWritten = Double.NaN;

  PluggedSlot(PluggedContext context, Frame frame, UrbiUVar variable, String name) {
    this.context = context;
    this.crossing = context.crossing();
    this.reference = new LooseReference<>(context.interpreter().scheduler().journal(), variable);
    boolean held = context.objects().keep(variable, KernelCrossing.self(frame.job()));
    this.kept = held ? null : variable;
    this.name = name;
    this.number = context.tasks().number(this);
  }

  @Override
  public String name() {
    return name;
  }

  /**
   * The variable. Once the object that kept it was garbage collected, another one without value:
   * the component may go on until it is told. That this is so is in the recording of a run.
   */
  UrbiUVar behind() {
    UrbiUVar variable = kept == null ? reference.get() : kept;
    if (variable == null) {
      variable = (UrbiUVar) context.interpreter().world().prototype("UVar").cloned();
      kept = variable;
    }
    return variable;
  }

  // ------------------------------------------------------------------ the value

  /** Does what a thread asks for. */
  @Nullable Object perform(Frame frame, Message.OfVariable asked) {
    return switch (asked) {
      case Message.VariableRead read ->
          switch (read.what()) {
            case VALUE -> get(frame);
            case TIMESTAMP -> timestamp(frame);
            case INPUT -> in(frame);
            case OUTPUT -> out(frame);
          };
      case Message.VariableWritten written -> set(frame, written.value());
      case Message.PropertyRead read -> property(frame, read.property());
      case Message.PropertyWritten written ->
          setProperty(frame, written.property(), written.value());
      case Message.VariableUsed used -> use(used.use(), used.on());
      case Message.VariableUnnotified ended -> endNotifications();
    };
  }

  private <T> T read(Message.Reading what, Function<Frame, T> task) {
    return crossing.fromKernel(task, this, asked -> new Message.VariableRead(asked, number, what));
  }

  @Override
  public UValue get() {
    return read(Message.Reading.VALUE, this::get);
  }

  private UValue get(Frame frame) {
    Datum told = context.notifications().find(frame.job(), behind());
    if (told != null && told.foreign() instanceof BypassValue foreign) {
      return foreign.value();
    }
    if (told != null && behind().isInput()) {
      return context.conversion().toJava(told.value());
    }
    UrbiObject value = owner || told != null ? seen().value() : behind().readNow(frame);
    return context.conversion().toJava(value);
  }

  private Datum seen() {
    return owner ? behind().target() : behind().visible();
  }

  @Override
  public void set(UValue value) {
    crossing.inKernel(
        frame -> set(frame, value),
        this,
        asked -> new Message.VariableWritten(asked, number, value));
  }

  private @Nullable Void set(Frame frame, UValue value) {
    Datum datum =
        bypass && value.getType() == UDataType.DATA_BINARY
            ? new Datum(new BypassValue(context.conversion(), value))
            : new Datum(context.conversion().toUrbi(value));
    lastWritten = value.getType() == UDataType.DATA_DOUBLE ? value.doubleValue() : Double.NaN;
    if (owner) {
      behind().set(frame, datum);
    } else {
      behind().write(frame, datum);
    }
    return null;
  }

  @Override
  public UValue sync() {
    return get();
  }

  @Override
  public long timestamp() {
    return read(Message.Reading.TIMESTAMP, this::timestamp);
  }

  private long timestamp(Frame frame) {
    return (long) (Math.max(0, behind().writes().last()) / NANOSECONDS_PER_MICROSECOND);
  }

  @Override
  public double in() {
    return read(Message.Reading.INPUT, this::in);
  }

  private double in(Frame frame) {
    return number(seen().value());
  }

  @Override
  public double out() {
    return read(Message.Reading.OUTPUT, this::out);
  }

  private double out(Frame frame) {
    return owner ? number(behind().visible().value()) : lastWritten;
  }

  private static double number(UrbiObject value) {
    return value instanceof UrbiFloat number ? number.value() : Double.NaN;
  }

  // ------------------------------------------------------------------ properties

  @Override
  public UValue property(UProperty property) {
    return crossing.fromKernel(
        frame -> property(frame, property),
        this,
        asked -> new Message.PropertyRead(asked, number, property));
  }

  private UValue property(Frame frame, UProperty property) {
    UrbiObject value = Properties.find(frame, object(), symbol(frame), property.text());
    return value == null ? new UValue() : context.conversion().toJava(value);
  }

  @Override
  public void setProperty(UProperty property, UValue value) {
    crossing.inKernel(
        frame -> setProperty(frame, property, value),
        this,
        asked -> new Message.PropertyWritten(asked, number, property, value));
  }

  private @Nullable Void setProperty(Frame frame, UProperty property, UValue value) {
    UrbiObject given = context.conversion().toUrbi(value);
    UrbiObject set =
        property == UProperty.PROP_CONSTANT
            ? frame.interpreter().values().bool(value.booleanValue())
            : given;
    Properties.set(frame, object(), symbol(frame), property.text(), set);
    return null;
  }

  private UrbiObject object() {
    UrbiObject object = behind().owner();
    if (object == null) {
      throw new IllegalStateException(Problem.VARIABLE_WITHOUT_OBJECT.text(name));
    }
    return object;
  }

  private Symbol symbol(Frame frame) {
    String full = behind().name();
    return frame.interpreter().world().symbol(full.substring(full.lastIndexOf('.') + 1));
  }

  // ------------------------------------------------------------------ how it behaves

  private void ask(Message.Use use, boolean on) {
    crossing.inKernel(
        frame -> use(use, on), this, asked -> new Message.VariableUsed(asked, number, use, on));
  }

  private @Nullable Void use(Message.Use use, boolean on) {
    switch (use) {
      case OWNED -> {
        behind().own(context::warn);
        owner = on;
      }
      case BYPASS -> {
        bypass = on;
        behind().setBypass(on);
      }
      // Within one process nothing is sent, but the setting also applies to remote subscribers.
      case RTP -> behind().setRtp(on);
    }
    return null;
  }

  @Override
  public void own() {
    ask(Message.Use.OWNED, true);
  }

  @Override
  public boolean isOwned() {
    return owner;
  }

  @Override
  public boolean setBypass(boolean on) {
    ask(Message.Use.BYPASS, on);
    return true;
  }

  @Override
  public void useRtp(boolean on) {
    ask(Message.Use.RTP, on);
  }

  @Override
  public void keepSynchronized() {
    // It always is.
  }

  // ------------------------------------------------------------------ notifications

  @Override
  public Runnable onChange(@Nullable UObject object, UCallback function) {
    return crossing.fromKernel(frame -> {
      JavaHook hook = new JavaHook(context, function);
      if (owner) {
        long id = behind().notifyChangeOwned(hook);
        return ending(() -> behind().removeChangeOwned(id));
      }
      long id = behind().notifyChange(frame.interpreter(), hook);
      return ending(() -> behind().removeChange(id));
    });
  }

  @Override
  public Runnable onAccess(@Nullable UObject object, UCallback function) {
    return crossing.fromKernel(frame -> {
      long id = behind().notifyAccess(frame, new JavaHook(context, function));
      return ending(() -> behind().removeAccess(id));
    });
  }

  private Runnable ending(Runnable removal) {
    Runnable end =
        () ->
            crossing.inKernel(frame -> {
              removal.run();
              return null;
            });
    notifications.add(end);
    return end;
  }

  @Override
  public void unnotify() {
    crossing.inKernel(
        frame -> endNotifications(), this, asked -> new Message.VariableUnnotified(asked, number));
  }

  private @Nullable Void endNotifications() {
    List<Runnable> all = List.copyOf(notifications);
    notifications.clear();
    all.forEach(Runnable::run);
    return null;
  }

  @Override
  public void close() {
    unnotify();
  }
}
