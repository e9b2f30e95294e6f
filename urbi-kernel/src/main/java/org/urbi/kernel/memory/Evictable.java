package org.urbi.kernel.memory;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;

/**
 * Somebody for whom a lobby executes code, who may have to give back its memory: the client of a
 * connection, or the program that embeds the kernel. Every method may be called on any thread.
 */
public interface Evictable {
  /** What its jobs are charged to; null while it has no lobby. */
  @Nullable Budget budget();

  /** Who it is, for people. */
  String description();

  /** Ends all its jobs, and tells it why. */
  void evict(String why);

  /** Whether jobs of it have not ended yet. */
  boolean isAtWork();

  /** Whether it cannot be {@linkplain #close() let go}. */
  boolean stays();

  /** Lets it go, which frees the objects of its lobby. */
  void close();
}
