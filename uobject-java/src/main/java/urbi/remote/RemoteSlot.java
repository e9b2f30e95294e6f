package urbi.remote;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.jspecify.annotations.Nullable;
import urbi.UCallback;
import urbi.UObject;
import urbi.UProperty;
import urbi.USlot;
import urbi.UValue;
import urbi.rtp.RtpMode;
import urbi.wire.Frame;

/**
 * A variable of the kernel in a remote process; its value is a copy that the kernel keeps up to
 * date.
 */
final class RemoteSlot implements USlot {
  /** How much the kernel is to tell about a variable. */
  static final int NOTHING = 0;

  static final int CHANGES_OF_OTHERS = 1;

  /** As {@link #CHANGES_OF_OTHERS}, but objects of this process are notified of each change. */
  static final int NOTIFIED = 3;

  private static final UValue NONE = new UValue();

  private final RemoteContext context;
  private final int id;
  private final String name;
  private final List<UCallback> onChange = new CopyOnWriteArrayList<>();
  private final List<UCallback> onAccess = new CopyOnWriteArrayList<>();
  private volatile UValue value = NONE;
  private boolean changed;
  private volatile UValue written = NONE;
  private volatile long timestamp;
  private volatile boolean owned;
  private volatile RtpMode rtp = RtpMode.RTP_DEFAULT;
  private int watched = CHANGES_OF_OTHERS;

  /**
   * At which {@linkplain RemoteContext#yields depth} this process is being notified; -1 for none.
   */
  private int telling = -1;

  RemoteSlot(RemoteContext context, int id, String name) {
    this.context = context;
    this.id = id;
    this.name = name;
  }

  int id() {
    return id;
  }

  @Override
  public String name() {
    return name;
  }

  @Override
  public UValue get() {
    return value;
  }

  @Override
  public void set(UValue other) {
    written = other;
    timestamp = context.now();
    if (!owned) {
      value = other;
    }
    context.set(id, other, rtp);
    if (!owned) {
      tellOwn(other);
    }
  }

  /** Notifies this process of its own change at once, as a plugged object would be. */
  private void tellOwn(UValue other) {
    for (UCallback callback : onChange) {
      if (callback.isThreaded() || !context.isInTurn()) {
        tell(callback, other);
      } else if (telling != context.yields()) {
        tellInTurn(() -> context.notifyNow(callback, other));
      }
    }
  }

  private void tell(UCallback callback, UValue other) {
    if (callback.isThreaded()) {
      context.notifyNow(callback, other);
    } else {
      context.later(() -> tellInTurn(() -> context.notifyInTurn(callback, other)));
    }
  }

  /** What is notified may set the variable, too, and is not notified of that. */
  private void tellInTurn(Runnable notification) {
    int outer = telling;
    telling = context.yields();
    try {
      notification.run();
    } finally {
      telling = outer;
    }
  }

  @Override
  public UValue sync() {
    return context.ask(
        (out, number) -> out.begin(Frame.SYNC).size(number).size(id).end(), fresh -> value = fresh);
  }

  /** The kernel tells of a new value. */
  void changed(long time, UValue other) {
    timestamp = time;
    synchronized (this) {
      changed = true;
      value = other;
    }
    for (UCallback callback : onChange) {
      tell(callback, other);
    }
  }

  /**
   * The kernel tells that the value is about to be read; it waits until it hears that all is said.
   */
  void accessed(int number) {
    Runnable done = () -> context.sendNow(out -> out.begin(Frame.ACCESSED).size(number).end());
    for (UCallback callback : onAccess) {
      context.notify(callback, value);
    }
    context.later(done);
  }

  /** Somebody has decided how the variable is to be sent. */
  void setRtp(RtpMode mode) {
    rtp = mode;
  }

  /** The value that it had when it was opened; it may have another one by now. */
  synchronized void setInitial(UValue initial) {
    if (!changed) {
      value = initial;
    }
  }

  @Override
  public long timestamp() {
    return timestamp;
  }

  @Override
  public double in() {
    return number(value);
  }

  @Override
  public double out() {
    return number(written);
  }

  private static double number(UValue of) {
    return switch (of.getType()) {
      case DATA_DOUBLE -> of.doubleValue();
      default -> Double.NaN;
    };
  }

  @Override
  public UValue property(UProperty property) {
    return context.ask((out, number) ->
        out.begin(Frame.GET_PROPERTY).size(number).size(id).text(property.text()).end());
  }

  @Override
  public void setProperty(UProperty property, UValue other) {
    context.send(
        out -> out.begin(Frame.SET_PROPERTY).size(id).text(property.text()).value(other).end());
  }

  @Override
  public void own() {
    owned = true;
    context.send(out -> out.begin(Frame.OWN).size(id).end());
  }

  @Override
  public boolean isOwned() {
    return owned;
  }

  @Override
  public Runnable onChange(@Nullable UObject object, UCallback function) {
    onChange.add(function);
    watch(NOTIFIED);
    return () -> {
      if (onChange.remove(function) && onChange.isEmpty()) {
        watch(CHANGES_OF_OTHERS);
      }
    };
  }

  @Override
  public Runnable onAccess(@Nullable UObject object, UCallback function) {
    if (onAccess.isEmpty()) {
      intercept(true);
    }
    onAccess.add(function);
    return () -> {
      if (onAccess.remove(function) && onAccess.isEmpty()) {
        intercept(false);
      }
    };
  }

  private void intercept(boolean on) {
    context.send(out -> out.begin(Frame.INTERCEPT).size(id).octet(on ? 1 : 0).end());
  }

  private synchronized void watch(int how) {
    if (watched != how) {
      watched = how;
      context.send(out -> out.begin(Frame.WATCH).size(id).octet(how).end());
    }
  }

  @Override
  public void unnotify() {
    onChange.clear();
    if (!onAccess.isEmpty()) {
      onAccess.clear();
      intercept(false);
    }
    watch(NOTHING);
  }

  @Override
  public void keepSynchronized() {
    watch(onChange.isEmpty() ? CHANGES_OF_OTHERS : NOTIFIED);
  }

  @Override
  public boolean setBypass(boolean on) {
    return false;
  }

  @Override
  public void useRtp(boolean on) {
    rtp = on ? RtpMode.RTP_YES : RtpMode.RTP_NO;
    context.send(out -> out.begin(Frame.RTP).size(id).octet(on ? 1 : 0).end());
  }

  @Override
  public void close() {
    context.forget(this);
  }
}
