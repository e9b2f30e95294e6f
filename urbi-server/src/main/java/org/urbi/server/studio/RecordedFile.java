package org.urbi.server.studio;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;

/** To which file variables are being recorded, for those who look. May be used from any thread. */
public final class RecordedFile {
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private volatile String name = "";

  /** Its name; empty while nothing is recorded. */
  public String name() {
    return name;
  }

  /**
   * Variables are recorded to another file from now on. Changes are told in the order in which they
   * happen.
   *
   * @param other its name; empty if to none any more
   */
  public synchronized void change(String other) {
    name = other;
    listeners.forEach(Runnable::run);
  }

  /**
   * Calls a listener at each change, on the thread on which it happens.
   *
   * @return what ends it
   */
  Runnable listen(Runnable changed) {
    listeners.add(changed);
    return () -> listeners.remove(changed);
  }
}
