package urbi;

import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * A variable of urbiscript (manual, "Using urbi variables"). Bound, it reads and writes the slot of
 * an object, from any thread.
 *
 * <p>Where it says so in {@link UObject#UOwned}, what this UVar reads and what it writes differ.
 */
// Constructors call the same methods to bind as users do, who may redefine them as in 2.7.
@SuppressWarnings("this-escape")
public class UVar {
  /** The least value; writing less writes this. */
  public final UProp rangemin = new UProp(this, UProperty.PROP_RANGEMIN);

  /** The greatest value; writing more writes this. */
  public final UProp rangemax = new UProp(this, UProperty.PROP_RANGEMAX);

  /** The least speed of a motion, in units per second. */
  public final UProp speedmin = new UProp(this, UProperty.PROP_SPEEDMIN);

  /** The greatest speed of a motion, in units per second. */
  public final UProp speedmax = new UProp(this, UProperty.PROP_SPEEDMAX);

  /** How near its target an adaptive motion at a speed is over. */
  public final UProp delta = new UProp(this, UProperty.PROP_DELTA);

  /** What becomes of several assignments at a time, see {@link UBlendType}. */
  public final UProp blend = new UProp(this, UProperty.PROP_BLEND);

  /** Not 0 if the variable may not be assigned. */
  public final UProp constant = new UProp(this, UProperty.PROP_CONSTANT);

  private final @Nullable UValue initial;
  private String name = "";
  private @Nullable UContext context;
  private @Nullable USlot slot;

  /** A variable to be bound by {@link UObject#UBindVar} or {@link #init}. */
  public UVar() {
    this((UValue) null, null);
  }

  private UVar(@Nullable UValue initial, @Nullable Void tag) {
    this.initial = initial;
  }

  /** A variable to be bound, which gets this value then. */
  public static UVar of(Object value) {
    return new UVar(UCast.toUValue(value), null);
  }

  /**
   * The variable of that name.
   *
   * @param name {@code object.slot}
   * @throws IllegalArgumentException if there is no such object
   */
  public UVar(String name) {
    this();
    init(name);
  }

  /** The variable that is a slot of an object. */
  public UVar(String object, String slot) {
    this();
    init(object, slot);
  }

  /** The variable that is a slot of an object. */
  public UVar(UObject object, String slot) {
    this();
    init(object.get__name(), slot, object.getUContext());
  }

  /** A second handle of the same variable. */
  public UVar(UVar other) {
    this();
    other.check();
    bind(other.name, other.context());
  }

  // ------------------------------------------------------------------ binding

  /** Binds it to the variable of that name: {@code object.slot}. */
  public void init(String full) {
    bind(full, UContext.current());
  }

  /** Binds it to the slot of an object. */
  public void init(String object, String slotName) {
    init(object, slotName, UContext.current());
  }

  /** Binds it to the slot of an object in a context. */
  public void init(String object, String slotName, UContext in) {
    bind(object + "." + slotName, in);
  }

  private void bind(String full, UContext in) {
    USlot before = slot;
    slot = open(in, full);
    context = in;
    name = slot.name();
    if (before != null) {
      before.close();
    }
    if (initial != null) {
      slot.set(initial);
    }
  }

  /** The context's side of it. */
  USlot open(UContext in, String full) {
    return in.variable(full);
  }

  boolean isBound() {
    return slot != null;
  }

  private USlot check() {
    USlot bound = slot;
    if (bound == null) {
      throw new IllegalStateException("invalid use of unbound UVar");
    }
    return bound;
  }

  /** Ends the use of the variable; reading or writing it is an error from now on. */
  public void close() {
    USlot bound = slot;
    if (bound != null) {
      slot = null;
      bound.close();
    }
  }

  /** The full name; empty if it is not bound. */
  public String getName() {
    return name;
  }

  public String get_name() {
    return name;
  }

  UContext context() {
    return Objects.requireNonNull(context, "a variable that is bound has a context");
  }

  // ------------------------------------------------------------------ writing

  /** Writes the value. It belongs to the variable then, and is not to be changed. */
  public void setValue(UValue value) {
    check().set(value);
  }

  public void setValue(double value) {
    setValue(new UValue(value));
  }

  public void setValue(long value) {
    setValue(new UValue((double) value));
  }

  /** Writes 1 for true, 0 for false. */
  public void setValue(boolean value) {
    setValue(new UValue(value));
  }

  public void setValue(char value) {
    setValue(new UValue(value));
  }

  public void setValue(String value) {
    setValue(new UValue(value));
  }

  public void setValue(UList value) {
    setValue(new UValue(value));
  }

  public void setValue(UDictionary value) {
    setValue(new UValue(value));
  }

  /** Writes a binary: a copy of it, except in {@linkplain #setBypass bypass} mode. */
  public void setValue(UBinary value) {
    setValue(new UValue(value));
  }

  /** Writes an image, as {@link #setValue(UBinary)}. */
  public void setValue(UImage value) {
    setValue(new UValue(value));
  }

  /** Writes a sound, as {@link #setValue(UBinary)}. */
  public void setValue(USound value) {
    setValue(new UValue(value));
  }

  /** Writes the value of another variable. */
  public void setValue(UVar value) {
    setValue(value.getUValue());
  }

  /** Writes what {@link UCast} makes a value of: collections, records… */
  public void setValue(Object value) {
    setValue(UCast.toUValue(value));
  }

  /** Writes a number; whatever it did in former versions, it does not matter who owns it. */
  public void reset(double value) {
    setValue(value);
  }

  // ------------------------------------------------------------------ reading

  /** The value; not to be changed. */
  public UValue getUValue() {
    return check().get();
  }

  /** The value; not to be changed. */
  public UValue val() {
    return getUValue();
  }

  /** What the value is. */
  public UDataType type() {
    return getUValue().getType();
  }

  public UDataType getType() {
    return type();
  }

  /** The number, or the one that the string is. */
  public double doubleValue() {
    return getUValue().doubleValue();
  }

  /** The number, as near as a float is to it. */
  public float floatValue() {
    return getUValue().floatValue();
  }

  /** The number without its decimals; where it is too large, its lowest 32 bits. */
  public int intValue() {
    return getUValue().intValue();
  }

  /** The number without its decimals; the nearest one where it is too large. */
  public long longValue() {
    return getUValue().longValue();
  }

  /** The lowest 16 bits of {@link #intValue}. */
  public short shortValue() {
    return (short) intValue();
  }

  /** The lowest 8 bits of {@link #intValue}. */
  public byte byteValue() {
    return (byte) intValue();
  }

  public char charValue() {
    return UCast.character(getUValue());
  }

  /** Whether the number is not 0. */
  public boolean booleanValue() {
    return getUValue().booleanValue();
  }

  /** The string, the number as text, or the name of the slot. */
  public String stringValue() {
    return getUValue().stringValue();
  }

  /** The list itself; changes of it are changes of the value that was read. */
  public UList ulistValue() {
    return getUValue().ulistValue();
  }

  public UDictionary udictionaryValue() {
    return getUValue().udictionaryValue();
  }

  /** The binary; a copy, except in {@linkplain #setBypass bypass} mode. */
  public UBinary ubinaryValue() {
    return getUValue().ubinaryValue();
  }

  public UImage uimageValue() {
    return getUValue().uimageValue();
  }

  public USound usoundValue() {
    return getUValue().usoundValue();
  }

  /**
   * The value as an instance of a Java type, records included.
   *
   * @throws UCastException if it is not
   */
  public <T> @Nullable T as(Class<T> type) {
    return getUValue().as(type);
  }

  // ------------------------------------------------------------------ the two sides of it

  /** From now on the module of this UVar owns the variable, see {@link UObject#UOwned}. */
  public void setOwned() {
    check().own();
  }

  /** Whether this module owns the variable. */
  public boolean getOwned() {
    return slot != null && slot.isOwned();
  }

  /** The number that is read here: of an owned variable the target. NaN if it is none. */
  public double in() {
    return check().in();
  }

  /**
   * The number that was written here last, or NaN if it is no number. Of an owned variable it is
   * what others read.
   */
  public double out() {
    return check().out();
  }

  /** When it was last written, in microseconds since the kernel was started. */
  public long timestamp() {
    return check().timestamp();
  }

  // ------------------------------------------------------------------ how it is kept

  /** Asks the kernel for the value, and waits until it is here. */
  public void syncValue() {
    check().sync();
  }

  /** Has each change of the value sent here, so that reading need not ask. */
  public void keepSynchronized() {
    check().keepSynchronized();
  }

  /** Ends all the notifications of this UVar; its value is no longer kept up to date. */
  public void unnotify() {
    check().unnotify();
  }

  /**
   * Enables the bypass (0-copy) mode: binaries written to the variable are not copied. They can be
   * read while notifications of the change are called; whoever reads at another time waits for the
   * next change (manual, "0-copy mode").
   *
   * @return whether it is possible: only plugged
   */
  public boolean setBypass(boolean enable) {
    return check().setBypass(enable);
  }

  /** Enables the bypass mode. */
  public boolean setBypass() {
    return setBypass(true);
  }

  /** Whether changes travel in datagrams between this module and the kernel. */
  public void useRTP(boolean enable) {
    check().useRtp(enable);
  }

  /** Has changes travel in datagrams between this module and the kernel. */
  public void useRTP() {
    useRTP(true);
  }

  // ------------------------------------------------------------------ properties

  /** The value of a property; void if the variable has no such property. */
  public UValue getProp(UProperty property) {
    return check().property(property);
  }

  public void setProp(UProperty property, UValue value) {
    check().setProperty(property, value);
  }

  public void setProp(UProperty property, double value) {
    setProp(property, new UValue(value));
  }

  public void setProp(UProperty property, String value) {
    setProp(property, new UValue(value));
  }

  public UProp getRangemin() {
    return rangemin;
  }

  public UProp getRangemax() {
    return rangemax;
  }

  public UProp getSpeedmin() {
    return speedmin;
  }

  public UProp getSpeedmax() {
    return speedmax;
  }

  public UProp getDelta() {
    return delta;
  }

  public UProp getBlend() {
    return blend;
  }

  public UProp getConstant() {
    return constant;
  }

  // ------------------------------------------------------------------ notifications

  Runnable onChange(UObject object, UCallback function) {
    return check().onChange(object, function);
  }

  Runnable onAccess(UObject object, UCallback function) {
    return check().onAccess(object, function);
  }

  /** The value as an urbiscript literal. */
  @Override
  public String toString() {
    return slot == null ? "unbound UVar" : getUValue().toString();
  }
}
