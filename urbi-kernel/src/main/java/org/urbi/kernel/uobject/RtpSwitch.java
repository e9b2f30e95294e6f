package org.urbi.kernel.uobject;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;

/**
 * Whether values may travel in datagrams between the kernel and remote processes: whether the
 * module {@code urbi/rtp} is loaded (manual, "Enabling RTP").
 */
public final class RtpSwitch {
  private final List<Consumer<Boolean>> listeners = new CopyOnWriteArrayList<>();
  private boolean on;

  RtpSwitch() {}

  public boolean isOn() {
    return on;
  }

  /** Loads or unloads the module; false if it was already so. */
  public boolean turn(boolean now) {
    if (on == now) {
      return false;
    }
    on = now;
    listeners.forEach(listener -> listener.accept(now));
    return true;
  }

  /** Adds a listener for changes; returns the action that removes it. */
  public Runnable onTurn(Consumer<Boolean> listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }
}
