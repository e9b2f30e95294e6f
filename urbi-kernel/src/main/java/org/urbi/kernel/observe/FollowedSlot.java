package org.urbi.kernel.observe;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiObject;

/**
 * Something with a value that somebody may follow. Until it has a value, nobody is told of it. On
 * the kernel thread.
 */
abstract class FollowedSlot {
  private final VariableFeed feed;
  private String path;
  private int number;
  private @Nullable VariableKind kind;
  private boolean followed;

  FollowedSlot(VariableFeed feed, String path) {
    this.feed = feed;
    this.path = path;
  }

  /** Its value right now; null if there is none. */
  abstract @Nullable UrbiObject now();

  /** From now on, {@link #seen} is to be called with each new value, or no longer. */
  abstract void listen(boolean on);

  /** Whether it is still there. */
  abstract boolean isThere();

  final String path() {
    return path;
  }

  final int number() {
    return number;
  }

  private boolean isTold() {
    return kind != null;
  }

  /** Whether somebody is told of its values, or is to be told when it has one. */
  private void review() {
    listen(followed || !isTold());
  }

  /** The slot is known from now on, and followed at once if the feed follows all. */
  final void begin() {
    UrbiObject value = now();
    if (value != null) {
      seen(value);
    }
    review();
  }

  /** Begins or ends to tell of its values. */
  final void follow(boolean on) {
    followed = on;
    UrbiObject value = now();
    if (on && value != null) {
      seen(value);
    }
    review();
  }

  /** The slot has that value now. */
  final void seen(UrbiObject value) {
    Object copy = SeenValue.of(value);
    VariableKind before = kind;
    VariableKind after = copy == null ? before : VariableKind.of(copy);
    if (after != null && before != null) {
      after = before.with(after);
    }
    if (after != before && after != null) {
      appear(after);
    }
    if (followed) {
      feed.tell(number, copy);
    }
  }

  private void appear(VariableKind as) {
    if (isTold()) {
      feed.disappeared(this);
    }
    kind = as;
    followed = feed.followsAll();
    number = feed.appeared(this, as);
    review();
  }

  /** The slot has been found under a better name. */
  final void rename(String better) {
    VariableKind as = kind;
    if (better.equals(path)) {
      return;
    }
    boolean told = isTold();
    if (told) {
      feed.disappeared(this);
      kind = null;
    }
    path = better;
    if (as != null) {
      appear(as);
      UrbiObject value = now();
      if (followed && value != null) {
        seen(value);
      }
    }
  }

  /** Nobody is told of it any more. */
  final void end() {
    listen(false);
    if (isTold()) {
      feed.disappeared(this);
      kind = null;
    }
  }
}
