package org.urbi.builtins;

import org.jspecify.annotations.Nullable;

/** What a lobby must be allowed so that its code can call a builtin (docs/networking.md). */
public enum Permission {
  /** Nothing: it only reads, or what it makes is new. */
  NOTHING("OBSERVER", false),

  /** It changes its target: a user must be allowed to, an observer may change its own only. */
  CHANGE("OBSERVER", true),

  /** The role {@code user}. */
  USER("USER", false),

  /** The role {@code owner}. */
  OWNER("OWNER", false),

  /** What the type says for all its builtins. */
  AS_TYPE(null, false);

  /** The name of the least role in the kernel. */
  final @Nullable String role;

  /** Whether the target is changed. */
  final boolean changes;

  Permission(@Nullable String role, boolean changes) {
    this.role = role;
    this.changes = changes;
  }
}
