package org.urbi.ros.two;

import java.util.LinkedHashSet;
import java.util.Set;
import java.util.concurrent.CompletionException;
import java.util.function.Consumer;

/**
 * Tells people what goes wrong, and the same thing only once: a peer may do it a thousand times a
 * second.
 */
public final class Reports {
  /** So many are remembered. */
  private static final int MOST = 100;

  private final Consumer<String> people;
  private final Set<String> told = new LinkedHashSet<>();

  /**
   * @param people are told, by whoever tells it
   */
  public Reports(Consumer<String> people) {
    this.people = people;
  }

  /** Tells it, unless it was told lately. */
  public void tell(String text) {
    synchronized (told) {
      if (!told.add(text)) return;
      if (told.size() > MOST) told.remove(told.iterator().next());
    }
    people.accept(text);
  }

  /** Tells what has failed, and why. */
  public void tell(String what, Throwable reason) {
    Throwable cause = reason instanceof CompletionException ? reason.getCause() : null;
    Throwable told = cause == null ? reason : cause;
    String message = told.getMessage();
    tell(what + ": " + (message == null ? told.getClass().getSimpleName() : message));
  }
}
