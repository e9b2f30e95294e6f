package org.urbi.ros.two;

import java.util.LinkedHashSet;
import java.util.Set;
import java.util.function.Consumer;

/**
 * Tells people what goes wrong, and the same thing only once: a peer may do it a thousand times a
 * second.
 */
final class Reports {
  /** So many are remembered. */
  private static final int MOST = 100;

  private final Consumer<String> people;
  private final Set<String> told = new LinkedHashSet<>();

  Reports(Consumer<String> people) {
    this.people = people;
  }

  void tell(String text) {
    synchronized (told) {
      if (!told.add(text)) return;
      if (told.size() > MOST) told.remove(told.iterator().next());
    }
    people.accept(text);
  }

  void tell(String what, Throwable reason) {
    String message = reason.getMessage();
    tell(what + ": " + (message == null ? reason.getClass().getSimpleName() : message));
  }
}
