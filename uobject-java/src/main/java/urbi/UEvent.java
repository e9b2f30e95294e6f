package urbi;

import org.jspecify.annotations.Nullable;

/** An event of urbiscript (manual, "Emitting events"). */
// Constructors call the same methods to bind as users do, who may redefine them as in 2.7.
@SuppressWarnings("this-escape")
public class UEvent {
  private String name = "";
  private @Nullable UEmitter emitter;

  /** An event to be bound by {@link UObject#UBindEvent} or {@link #init}. */
  public UEvent() {}

  /** The event of that name: {@code object.slot}. */
  public UEvent(String name) {
    bind(name, UContext.current());
  }

  /** The event that is a slot of an object. */
  public UEvent(String object, String slot) {
    init(object, slot);
  }

  /** The event that is a slot of an object. */
  public UEvent(UObject object, String slot) {
    init(object.get__name(), slot, object.getUContext());
  }

  /** Binds it to the slot of an object. */
  public void init(String object, String slot) {
    init(object, slot, UContext.current());
  }

  /** Binds it to the slot of an object in a context. */
  public void init(String object, String slot, UContext context) {
    bind(object + "." + slot, context);
  }

  private void bind(String full, UContext context) {
    emitter = context.event(full);
    name = full;
  }

  /** Its full name; empty if it is not bound. */
  public String getName() {
    return name;
  }

  public String get_name() {
    return name;
  }

  boolean isBound() {
    return emitter != null;
  }

  /**
   * Emits the event. Its handlers may run later.
   *
   * @param payload made values by {@link UCast#toUValue}
   * @throws IllegalStateException if it is not bound
   */
  public void emit(Object... payload) {
    if (emitter == null) {
      throw new IllegalStateException("invalid use of unbound UEvent");
    }
    UValue[] values = new UValue[payload.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = UCast.toUValue(payload[i]);
    }
    emitter.emit(values);
  }

  /** Emits the event, as {@link #emit} does. */
  public void trigger(Object... payload) {
    emit(payload);
  }

  @Override
  public String toString() {
    return name.isEmpty() ? "unbound UEvent" : name;
  }
}
