package org.urbi.kernel.remote;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.uobject.PluggedContext;
import org.urbi.kernel.variable.UrbiUVar;
import urbi.UCallback;
import urbi.USlot;
import urbi.UValue;
import urbi.rtp.RtpMode;

/** A variable that a remote process has opened. */
final class RemoteVariable {
  private static final int NOTHING = 0;
  private static final int ALL_CHANGES = 2;

  /** The process is notified of its own changes by itself. */
  private static final int NOTIFIED = 3;

  private static final MethodHandle CHANGED = find("changed", UValue.class);
  private static final MethodHandle ACCESSED = find("accessed");

  private final RemotePeer peer;
  private final int id;
  private final USlot slot;
  private @Nullable Runnable notification;
  private @Nullable Runnable interception;
  private int watch;
  private @Nullable UValue beingSet;
  private boolean stale;
  private boolean mirror;
  private int accesses;
  private @Nullable UValue accessed;
  private final Runnable rtpEnd;

  RemoteVariable(RemotePeer peer, int id, USlot slot) {
    this.peer = peer;
    this.id = id;
    this.slot = slot;
    this.rtpEnd = variable().onRtp(() -> peer.datagrams().tellMode(this));
  }

  private static MethodHandle find(String name, Class<?>... parameters) {
    try {
      return MethodHandles.lookup()
          .findVirtual(RemoteVariable.class, name, MethodType.methodType(void.class, parameters));
    } catch (ReflectiveOperationException e) {
      throw new ExceptionInInitializerError(e);
    }
  }

  int id() {
    return id;
  }

  USlot slot() {
    return slot;
  }

  /** Not kept here: it may lead to the object whose slot it is. */
  private UrbiUVar variable() {
    return PluggedContext.behind(slot);
  }

  /** Whether its values travel in datagrams. */
  RtpMode rtp() {
    Boolean on = variable().rtp();
    if (on == null) {
      return RtpMode.RTP_DEFAULT;
    }
    return on ? RtpMode.RTP_YES : RtpMode.RTP_NO;
  }

  private UCallback callback(MethodHandle handle) {
    return UCallback.of(slot.name(), handle.bindTo(this));
  }

  /** How often the process uses it: once for itself, and once for what is notified of changes. */
  int uses() {
    return isNotified() ? 2 : 1;
  }

  /** The process wants no more changes. */
  void unwatch() {
    watch(NOTHING);
  }

  /** Whether something in the process is notified of changes. */
  private boolean isNotified() {
    return watch == ALL_CHANGES || watch == NOTIFIED;
  }

  /** Sets which changes the process wants to be sent. */
  void watch(int how) {
    watch = how;
    if (notification != null && how == NOTHING) {
      notification.run();
      notification = null;
    } else if (notification == null && how != NOTHING) {
      notification = slot.onChange(null, callback(CHANGED));
    }
    reviewMirror();
  }

  /**
   * Decides whether the process only keeps a copy: one that sets the value on access must not
   * trigger that access itself.
   */
  private void reviewMirror() {
    boolean now = notification != null && interception != null && !isNotified() && !slot.isOwned();
    if (now != mirror) {
      mirror = now;
      peer.countMirror(variable(), now);
    }
  }

  /** The process becomes the owner of the variable, so it is sent other changes than before. */
  void own() {
    int how = watch;
    watch(NOTHING);
    slot.own();
    watch(how);
  }

  void intercept(boolean on) {
    if (interception != null && !on) {
      interception.run();
      interception = null;
    } else if (interception == null && on) {
      interception = slot.onAccess(null, callback(ACCESSED));
    }
    reviewMirror();
  }

  /** The process sets the value, which is not sent back unless the kernel has modified it. */
  void set(UValue value) {
    if (accesses > 0) {
      accessed = value;
    } else {
      setNow(value);
    }
  }

  private void setNow(UValue value) {
    beingSet = value;
    try {
      slot.set(value);
    } finally {
      beingSet = null;
    }
  }

  void changed(UValue value) {
    UValue own = beingSet;
    if (own == null || watch == ALL_CHANGES || !own.equals(value)) {
      stale = !peer.tell(this, value);
    }
  }

  /** Sends the latest value, which was held back. */
  void refresh() {
    if (stale) {
      stale = false;
      changed(slot.get());
    }
  }

  /**
   * The variable is about to be read. A value that the process sets for this access is assigned by
   * the reading job, as with a plugged object, so that a condition does not react to a change that
   * it has caused itself.
   */
  void accessed() {
    accesses++;
    boolean done = false;
    try {
      peer.announceAccess(this);
      done = true;
    } finally {
      accesses--;
      if (!done) {
        peer.later(this::setAccessed);
      }
    }
    setAccessed();
  }

  private void setAccessed() {
    UValue value = accessed;
    accessed = null;
    if (value != null) {
      setNow(value);
    }
  }

  void close() {
    rtpEnd.run();
    notification = null;
    interception = null;
    reviewMirror();
    slot.close();
  }
}
