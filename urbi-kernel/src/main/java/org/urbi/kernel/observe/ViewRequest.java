package org.urbi.kernel.observe;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * What somebody wants to see.
 *
 * @param selected the number of the job whose calls are wanted; 0 for none
 * @param traced the numbers of the jobs whose turns are wanted; those beyond {@link #MOST_TRACED}
 *     are passed over
 * @param reactions only the reactions and events with this text are wanted; null for none at all
 * @param objects the ways to the objects whose slots are wanted, as {@link Places} says; those
 *     beyond {@link #MOST_OBJECTS} are passed over; null if not even the names of the lobbies are
 *     wanted
 */
public record ViewRequest(
    long selected, List<Long> traced, @Nullable String reactions, @Nullable List<String> objects) {
  /** The turns of how many jobs can be had at a time. */
  public static final int MOST_TRACED = 64;

  /** The slots of how many objects can be had at a time. */
  public static final int MOST_OBJECTS = 32;

  public ViewRequest {
    traced = traced.stream().distinct().limit(MOST_TRACED).toList();
    objects = objects == null ? null : objects.stream().distinct().limit(MOST_OBJECTS).toList();
  }
}
