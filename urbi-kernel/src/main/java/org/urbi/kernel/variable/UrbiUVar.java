package org.urbi.kernel.variable;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.event.Occurrences;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.lobby.Diagnostics;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.node.SlotUpdate;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.SlotData;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.trust.RoleHolder;

/**
 * A variable with hooks, which provides the value of a slot (manual, "UVar").
 *
 * <p>An owned one has two values: a target, which everybody writes and its owner reads, and a
 * sensed value, which its owner writes and everybody reads.
 *
 * <p>It keeps alive the objects whose slots it provides: who has the variable can write it, and
 * handlers of those slots run then.
 */
public final class UrbiUVar extends UrbiObject {
  /** A slot whose value the variable provides. */
  private record Place(UrbiObject owner, SlotData slot) {
    /** The data of the slot; null if the slot no longer exists. */
    @Nullable SlotData data() {
      return slot.isRemoved() ? null : slot;
    }
  }

  private final List<Place> places = new ArrayList<>(1);

  /** The properties of all its slots. */
  private final TreeMap<String, UrbiObject> properties = new TreeMap<>();

  private final Hooks onChange = new Hooks();
  private final Hooks onChangeOwned = new Hooks();
  private final Hooks onAccess = new Hooks();

  /** Copied on write, because passing on values may change the list. */
  private List<UrbiConnection> connections = List.of();

  private final BypassReaders readers = new BypassReaders();
  private @Nullable AccessLoop accessLoop;

  /** The jobs that are reading it, and run the access hooks for that. */
  private final Set<Job> accessing = new HashSet<>(0);

  private int mirrors;
  private @Nullable UrbiEvent changed;
  private @Nullable UrbiObject lobby;
  private String name = "";
  private Datum value;
  private Datum sensed;
  private boolean owned;
  private boolean input;
  private final Symbol inputPort;
  private boolean bypass;
  private boolean silent;
  private @Nullable RangeWarning rangeWarning;
  private @Nullable Boolean rtp;
  private final List<Runnable> onRtp = new ArrayList<>(0);
  private final Occurrences writes = new Occurrences();
  private long lastId;

  public UrbiUVar(Shape shape) {
    super(shape);
    inputPort = world().symbol("inputPort");
    value = new Datum(world().values().voidObject);
    sensed = value;
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiUVar(cloneShape());
  }

  // ------------------------------------------------------------------ where it stands

  /** The variable behind the object's own slot, or null. */
  public static @Nullable UrbiUVar behind(UrbiObject owner, Symbol slot) {
    SlotData data = owner.slotData(slot);
    boolean hooked = data != null && data.setter() instanceof Access;
    return hooked && owner.localSlot(slot) instanceof UrbiUVar variable ? variable : null;
  }

  /**
   * Makes this variable provide a slot of an object. The first time, it takes over the slot's
   * value.
   *
   * @param shown the name of the object in messages
   * @param tellsChanges whether the slot has the property {@code changed}, an event
   */
  public void bind(
      Interpreter interpreter, UrbiObject owner, Symbol slot, String shown, boolean tellsChanges) {
    UrbiObject known = owner.localSlot(slot);
    if (places.isEmpty()) {
      name = shown + "." + slot.name();
      KnownVariables.of(interpreter).add(this);
      if (known != null) {
        value = new Datum(known);
        sensed = value;
      }
    }
    if (known == null) {
      owner.addSlot(slot, this);
    } else {
      owner.setSlotAt(owner.shape().indexOf(slot), this);
    }
    SlotData data = owner.ensureSlotData(slot);
    data.shareProperties(properties);
    places.add(new Place(owner, data));
    Shape code = interpreter.prototypes().code.cloneShape();
    data.setGetter(new Access(code, false));
    data.setSetter(new Access(code, true));
    if (tellsChanges && data.changed() == null) {
      UrbiObject event = changed(interpreter);
      data.setChanged(event);
      data.setProperty("changed", event);
    }
    owner.slotDataChanged(slot);
  }

  /** Its name in messages: {@code object.slot}. */
  public String name() {
    return name;
  }

  /** The object of its first slot; null if there is none. */
  public @Nullable UrbiObject owner() {
    return places.isEmpty() ? null : places.getFirst().owner;
  }

  /** The lobby for which the access loop reads it. */
  UrbiObject lobby() {
    return requireNonNull(lobby, "there is somebody who sets the value");
  }

  // ------------------------------------------------------------------ how it behaves

  public boolean isOwned() {
    return owned;
  }

  /**
   * Splits the value into a target and a sensed value, which both start with the current value.
   *
   * @param warned called with a warning when targets leave the range
   */
  public void own(Consumer<String> warned) {
    own();
    rangeWarning = new RangeWarning(name, warned);
  }

  /** From now on it has a target and a sensed value, both what the value was. */
  public void own() {
    if (!owned) {
      owned = true;
      sensed = value;
    }
  }

  /**
   * Whether it only passes values on and stores none: created so, or by its slot {@code inputPort}.
   */
  public boolean isInput() {
    return input || localSlot(inputPort) == world().values().trueObject;
  }

  public void makeInput() {
    input = true;
  }

  /**
   * Switches the bypass mode, in which the value can be read only while hooks are called for it
   * (manual, "0-copy mode").
   */
  public void setBypass(boolean on) {
    bypass = on;
    if (on) {
      forget();
    }
  }

  /** Drops the value: nothing can be read until the next one is written. */
  private void forget() {
    sensed = new Datum(world().values().nil);
    if (!owned) {
      value = sensed;
    }
  }

  /**
   * Whether its values travel in datagrams to and from remote processes (manual, "Per-UVar control
   * of RTP mode"): the setting of the variable, or else of the prototype; null if neither is set.
   */
  public @Nullable Boolean rtp() {
    UrbiUVar prototype = general();
    return rtp != null || prototype == this ? rtp : prototype.rtp;
  }

  /** Sets whether they do; on the prototype, for all variables without a setting of their own. */
  public void setRtp(@Nullable Boolean on) {
    rtp = on;
    List.copyOf(onRtp).forEach(Runnable::run);
  }

  /** Adds a listener for changes of that setting; returns the action that removes it. */
  public Runnable onRtp(Runnable listener) {
    // Not the variable itself: whoever holds the action need not keep it.
    List<List<Runnable>> both = List.of(onRtp, general().onRtp);
    both.forEach(listeners -> listeners.add(listener));
    return () -> both.forEach(listeners -> listeners.remove(listener));
  }

  private UrbiUVar general() {
    return (UrbiUVar) world().prototype("UVar");
  }

  /** The event that is emitted with each new value. */
  public UrbiEvent changed(Interpreter interpreter) {
    if (changed == null) {
      changed = (UrbiEvent) interpreter.prototypes().event.cloned();
      changed.setOnSubscribe(() -> reviewAccess(interpreter));
    }
    return changed;
  }

  // ------------------------------------------------------------------ hooks

  /**
   * Adds a hook for changes of the value that everybody reads; returns the number by which to
   * remove it.
   */
  public long notifyChange(Interpreter interpreter, Hook hook) {
    onChange.add(++lastId, hook);
    reviewAccess(interpreter);
    return lastId;
  }

  /** Adds a hook for changes of the target; returns the number by which to remove it. */
  public long notifyChangeOwned(Hook hook) {
    onChangeOwned.add(++lastId, hook);
    return lastId;
  }

  /** Adds a hook that runs before each access; returns the number by which to remove it. */
  public long notifyAccess(Frame frame, Hook hook) {
    onAccess.add(++lastId, hook);
    UrbiObject installer = frame.job().lobby();
    if (lobby == null || RoleHolder.roleOf(installer).compareTo(RoleHolder.roleOf(lobby)) >= 0) {
      // As with other readers, who may do more does not wait for the hook of who may do less.
      lobby = installer;
    }
    reviewAccess(frame.interpreter());
    return lastId;
  }

  /**
   * Changes the number of change hooks whose owners only keep a copy, and themselves set the value
   * on access: the access loop need not read the variable for them.
   */
  public void countMirror(Interpreter interpreter, boolean one) {
    mirrors += one ? 1 : -1;
    reviewAccess(interpreter);
  }

  public boolean removeChange(long id) {
    return onChange.remove(id);
  }

  public boolean removeChangeOwned(long id) {
    return onChangeOwned.remove(id);
  }

  public boolean removeAccess(long id) {
    return onAccess.remove(id);
  }

  /** How many functions are called when the value changes that everybody reads. */
  public int listenerCount() {
    return onChange.size();
  }

  /** The connections that start at this variable. */
  public List<UrbiConnection> connections() {
    return connections;
  }

  void add(Frame frame, UrbiConnection connection) {
    connections = Stream.concat(connections.stream(), Stream.of(connection)).toList();
    reviewAccess(frame.interpreter());
  }

  void remove(UrbiConnection connection) {
    connections = connections.stream().filter(other -> other != connection).toList();
  }

  /**
   * Starts or ends the access loop, which reads the variable periodically if some hook sets its
   * value on access and others subscribe to its changes.
   */
  private void reviewAccess(Interpreter interpreter) {
    // A condition that is being evaluated will subscribe to what it reads.
    if (accessLoop == null && !onAccess.isEmpty() && (world().tracker != null || isWatched())) {
      accessLoop = new AccessLoop(interpreter, this);
    }
  }

  /** Whether some hook sets the value on access, and others subscribe to its changes. */
  boolean needsAccess() {
    return !onAccess.isEmpty() && isWatched();
  }

  /** The access loop has ended. */
  void accessLoopEnded() {
    accessLoop = null;
  }

  private boolean isWatched() {
    if (onChange.size() > mirrors
        || !connections.isEmpty()
        || changed != null && changed.hasSubscribers()) {
      return true;
    }
    for (Place place : places) {
      SlotData data = place.data();
      if (data != null && data.dependents() != null && !data.dependents().isEmpty()) {
        return true;
      }
    }
    return false;
  }

  // ------------------------------------------------------------------ reading

  /**
   * The value that everybody reads, after running the access hooks. In bypass mode, waits for the
   * next value, and returns {@code nil} if none is written within half a second.
   */
  public UrbiObject read(Frame frame) {
    UrbiObject present = readNow(frame);
    if (!bypass || !isForgotten() || world().tracker != null) {
      return present;
    }
    UrbiObject next = readers.await(frame.job());
    return next == null ? world().values().nil : next;
  }

  /** As {@link #read}, but never waits: in bypass mode there may be no value. */
  public UrbiObject readNow(Frame frame) {
    if (!onAccess.isEmpty()) {
      boolean first = accessing.add(frame.job());
      try {
        readInLoop(frame);
      } finally {
        if (first) {
          accessing.remove(frame.job());
        }
      }
      reviewAccess(frame.interpreter());
    }
    return visible().value();
  }

  /** Runs the access hooks as {@link #read} does, but handlers of changes are told, too. */
  void readInLoop(Frame frame) {
    onAccess.run(frame, this, visible());
  }

  private boolean isForgotten() {
    return visible().foreign() == null && visible().value() == world().values().nil;
  }

  /** The value that everybody reads; no hook is run. */
  public Datum visible() {
    return owned ? sensed : value;
  }

  /** The target of an owned variable; of others, the value. No hook is run. */
  public Datum target() {
    return value;
  }

  /** How often it was written, and when last. */
  public Occurrences writes() {
    return writes;
  }

  // ------------------------------------------------------------------ writing

  /**
   * Writes as everybody does: to the target of an owned variable. Hooks are run afterwards.
   *
   * @return what was written: the given value, or what the range has made of it
   */
  public Datum write(Frame frame, Datum datum) {
    if (!owned) {
      return set(frame, datum);
    }
    writes.note(frame.interpreter().scheduler().now());
    Datum assigned = inRange(frame, datum);
    value = assigned;
    if (rangeWarning != null) {
      rangeWarning.note(datum, assigned);
    }
    if (!silent) {
      onChangeOwned.run(frame, this, assigned);
    }
    return assigned;
  }

  /**
   * Writes as the owner of an owned variable does, or as anybody if it is not owned: changes what
   * everybody reads.
   *
   * @return what was written: the given value, or what the range has made of it
   */
  public Datum set(Frame frame, Datum datum) {
    Datum assigned = bypass ? datum : inRange(frame, datum);
    writes.note(frame.interpreter().scheduler().now());
    if (!isInput()) {
      if (owned) {
        sensed = assigned;
      } else {
        value = assigned;
      }
    }
    try {
      tell(frame, assigned);
    } finally {
      if (bypass && assigned.foreign() != null) {
        readers.deliver(assigned.value());
        if (visible() == assigned) {
          forget();
        }
      }
    }
    return assigned;
  }

  private void tell(Frame frame, Datum assigned) {
    if (silent) {
      return;
    }
    onChange.run(frame, this, assigned);
    if (!owned) {
      onChangeOwned.run(frame, this, assigned);
    }
    List<UrbiConnection> present = connections;
    for (int i = 0; i < present.size(); i++) {
      present.get(i).pass(frame, assigned);
    }
    // The access loop tells of what is set on access: a handler that reads the variable would start
    // itself again and again.
    if (changed != null && changed.hasSubscribers() && !accessing.contains(frame.job())) {
      changed.emit(frame, assigned.value());
    }
    for (int i = 0; i < places.size(); i++) {
      SlotData data = places.get(i).data();
      if (data != null && data.dependents() != null) {
        data.dependents().changed();
      }
    }
  }

  /** Sets whether notifications are suppressed for now. */
  public void silence(boolean on) {
    silent = on;
  }

  /** Restores former values, without notifications. */
  public void restore(Datum target, Datum seen) {
    value = target;
    sensed = seen;
  }

  /** The value limited to the properties rangemin and rangemax. */
  private Datum inRange(Frame frame, Datum assigned) {
    // A Java value is not limited, because reading it here would copy it.
    if (assigned.foreign() != null || !(assigned.value() instanceof UrbiFloat number)) {
      return assigned;
    }
    UrbiObject least = properties.get("rangemin");
    UrbiObject most = properties.get("rangemax");
    double limited = number.value();
    if (least instanceof UrbiFloat bound) {
      limited = Math.max(limited, bound.value());
    }
    if (most instanceof UrbiFloat bound) {
      limited = Math.min(limited, bound.value());
    }
    return limited == number.value() || Double.isNaN(limited)
        ? assigned
        : new Datum(frame.interpreter().values().number(limited));
  }

  // ------------------------------------------------------------------ failures

  /** Whether hooks that fail are removed. */
  boolean removesFailed(Frame frame) {
    UrbiObject remove = lookup(world().symbol("eraseThrowingCallbacks"));
    return remove != null && Truth.of(frame, remove);
  }

  void reportFailure(Frame frame, UrbiException failure) {
    if (frame.job().lobby() instanceof UrbiLobby told && told.isInstance()) {
      Diagnostics.error(told.output(), Problem.CAUGHT_IN_NOTIFY.text(name));
    }
    frame.interpreter().report(frame.job(), failure);
  }

  /** Reads or writes the variable when its slot is read or written. */
  private final class Access extends Code implements SlotUpdate.Whole {
    private final boolean writes;

    Access(Shape shape, boolean writes) {
      super(shape);
      this.writes = writes;
    }

    @Override
    public boolean isLazy() {
      return false;
    }

    @Override
    public UrbiObject call(Frame caller, CallSite site, UrbiObject self, UrbiObject... arguments) {
      if (!writes) {
        return read(caller);
      }
      return write(caller, new Datum(arguments[0])).value();
    }
  }
}
