package urbi;

import org.jspecify.annotations.Nullable;

/**
 * The context's side of one {@link UVar}: a variable of urbiscript as one module sees it.
 *
 * <p>An owned variable (manual, "The special case of sensor/actuator variables") has two values:
 * the module that owns it reads the target and writes the sensed value, all the others read the
 * sensed value and write the target.
 *
 * <p>Reading by {@link #get} has the access notifications of others called first; writing by {@link
 * #set} has the change notifications called after, as a read or a write in urbiscript does.
 */
public interface USlot {
  /** Its full name. */
  String name();

  /**
   * The value, as far as it is known here: a remote module may see an old one, unless it is
   * synchronized. Not to be modified. In bypass mode the value itself, for as long as a
   * notification lasts.
   */
  UValue get();

  /**
   * Changes the value; urbiscript may bring it into the range {@code rangemin}…{@code rangemax}.
   */
  void set(UValue value);

  /** Asks the kernel for the value, and waits for it. */
  UValue sync();

  /** When it was last written, in microseconds since the kernel was started. */
  long timestamp();

  /** The number that this module reads; NaN if it is none. */
  double in();

  /** The number that this module has written last; NaN if it is none. */
  double out();

  /** The value of a property; void if it has none. */
  UValue property(UProperty property);

  void setProperty(UProperty property, UValue value);

  /** From now on this module owns the variable. */
  void own();

  boolean isOwned();

  /**
   * Has a function called after each change; it has one argument, the new value, or none. If this
   * module owns the variable, changes are those of the target, else those of what it reads.
   *
   * @param object whose function it is; null for nobody's
   * @return what ends it
   */
  Runnable onChange(@Nullable UObject object, UCallback function);

  /**
   * Has a function called before each access, so that it may set the value; it has one argument,
   * the value, or none.
   *
   * @param object whose function it is; null for nobody's
   * @return what ends it
   */
  Runnable onAccess(@Nullable UObject object, UCallback function);

  /** Ends all notifications of this UVar, and the synchronization of its value. */
  void unnotify();

  /** Has each change of the value sent here, although nobody is notified of it. */
  void keepSynchronized();

  /**
   * Switches the bypass (0-copy) mode: binaries that are written are not copied, and can be read
   * during notifications only.
   *
   * @return whether the context can do that: remote ones cannot
   */
  boolean setBypass(boolean on);

  /** Whether changes may be sent in datagrams, which are faster and may get lost. */
  void useRtp(boolean on);

  /** The UVar is no longer used. */
  void close();
}
