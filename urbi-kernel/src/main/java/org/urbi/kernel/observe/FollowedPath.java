package org.urbi.kernel.observe;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.event.WatchedSources;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.object.Dependencies;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/**
 * A slot of any object, by its path. It may come later, and objects on the way may be replaced: all
 * that was read on the way is watched, as by a condition.
 */
final class FollowedPath extends FollowedSlot implements Dependencies.Watcher {
  private final SlotPath slot;
  private final World world;
  private final WatchedSources sources = new WatchedSources(this);
  private @Nullable Object last;
  private boolean ended;

  FollowedPath(VariableFeed feed, SlotPath slot, World world) {
    super(feed, slot.text());
    this.slot = slot;
    this.world = world;
  }

  @Override
  @Nullable UrbiObject now() {
    Dependencies.Tracker outer = world.tracker;
    world.tracker = sources;
    sources.begin();
    try {
      UrbiObject value = slot.value();
      // What is in it is watched, too.
      last = value == null ? null : SeenValue.of(value);
      return value;
    } finally {
      sources.end();
      world.tracker = outer;
    }
  }

  @Override
  public void invalidated() {
    if (ended) {
      return;
    }
    try {
      Object before = last;
      UrbiObject value = now();
      if (value != null && !Objects.equals(before, last)) {
        seen(value);
      }
    } catch (RuntimeException e) {
      // Whoever has changed the slot is not to blame.
      FailureLog.internal("following " + path(), e);
    }
  }

  /** A path is always watched: it leads elsewhere when an object on the way is replaced. */
  @Override
  void listen(boolean on) {}

  @Override
  boolean isThere() {
    return !ended;
  }

  /** Watches nothing any more. */
  void close() {
    ended = true;
    sources.close();
  }
}
