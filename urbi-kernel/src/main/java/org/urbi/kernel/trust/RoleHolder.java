package org.urbi.kernel.trust;

import org.jspecify.annotations.Nullable;

/** Something for which code runs, and which says what that may do. */
public interface RoleHolder {
  /** What the code may do. */
  Role role();

  /** The role of that thing; everything is allowed to what has none. */
  static Role roleOf(@Nullable Object of) {
    return of instanceof RoleHolder trusted ? trusted.role() : Role.OWNER;
  }
}
