package org.urbi.web;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.WeakHashMap;
import org.jspecify.annotations.Nullable;

/**
 * The pages of the components that live in one place, by the names of the components. They are kept
 * here because those who show them and those who bring them know neither each other nor the same
 * classes. May be used from any thread.
 */
public final class Annexes {
  private static final Map<Object, Annexes> PLACES = new WeakHashMap<>();

  private final Map<String, Annex> annexes = new LinkedHashMap<>();
  private final List<Runnable> listeners = new ArrayList<>();

  private Annexes() {}

  /**
   * The annexes of a place.
   *
   * @param place where components live; it is not kept
   */
  public static Annexes of(Object place) {
    synchronized (PLACES) {
      return PLACES.computeIfAbsent(place, unknown -> new Annexes());
    }
  }

  /** A component has a page from now on, or another one. */
  public void put(String component, Annex annex) {
    synchronized (this) {
      annexes.put(component, annex);
    }
    tell();
  }

  /** A component has no page any more. */
  public void remove(String component) {
    synchronized (this) {
      annexes.remove(component);
    }
    tell();
  }

  /** The page of a component; null if it has none. */
  public synchronized @Nullable Annex find(String component) {
    return annexes.get(component);
  }

  /** All of them, the oldest first. */
  public synchronized Map<String, Annex> all() {
    return new LinkedHashMap<>(annexes);
  }

  /**
   * Calls a listener when one has come or gone, on the thread on which that happens.
   *
   * @return what ends it
   */
  public synchronized Runnable listen(Runnable changed) {
    listeners.add(changed);
    return () -> forget(changed);
  }

  private synchronized void forget(Runnable listener) {
    listeners.remove(listener);
  }

  private void tell() {
    List<Runnable> told;
    synchronized (this) {
      told = List.copyOf(listeners);
    }
    told.forEach(Runnable::run);
  }
}
