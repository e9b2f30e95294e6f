package org.urbi.ros.two;

import java.util.LinkedHashSet;
import java.util.Set;
import java.util.function.Consumer;
import org.urbi.ros.graph.Failures;

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
    if (isNew(text)) people.accept(text);
  }

  /** Tells what has failed, and why; a defect of ours is logged, too. */
  public void tell(String what, Throwable reason) {
    String text = what + ": " + Failures.text(reason);
    if (isNew(text)) {
      Failures.told(what, reason);
      people.accept(text);
    }
  }

  private boolean isNew(String text) {
    synchronized (told) {
      if (!told.add(text)) return false;
      if (told.size() > MOST) told.remove(told.iterator().next());
      return true;
    }
  }
}
