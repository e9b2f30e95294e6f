package org.urbi.builtins;

import org.jspecify.annotations.Nullable;

/** The permission that a lobby needs for calling a builtin (docs/networking.md). */
public enum Permission {
  /** None: the builtin only reads, or creates new objects. */
  NOTHING("OBSERVER", false),

  /**
   * The builtin changes its target: users need permission for that object, observers may only
   * change their own.
   */
  CHANGE("OBSERVER", true),

  /** The role {@code user}. */
  USER("USER", false),

  /** The role {@code owner}. */
  OWNER("OWNER", false),

  /** The permission that the class sets for all its builtins. */
  AS_TYPE(null, false);

  /** The name of the lowest role, as in the kernel. */
  final @Nullable String role;

  /** Whether the target is changed. */
  final boolean changes;

  Permission(@Nullable String role, boolean changes) {
    this.role = role;
    this.changes = changes;
  }
}
