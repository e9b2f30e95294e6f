package org.urbi.sim.page;

/** Takes what people who look at a page want of the world. On the thread of the page. */
@FunctionalInterface
public interface Orders {
  /**
   * Somebody wants something.
   *
   * @param viewer who, for {@link PageServer#tell}
   * @param order words that are separated by spaces; they may be nonsense
   */
  void take(String viewer, String order);
}
