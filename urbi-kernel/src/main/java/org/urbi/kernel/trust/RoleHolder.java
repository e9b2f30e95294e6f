package org.urbi.kernel.trust;

import org.jspecify.annotations.Nullable;

/** An object (a lobby) on whose behalf code runs, and whose role tells what that code may do. */
public interface RoleHolder {
  /** The role of the code. */
  Role role();

  /** The role of an object; an object that is no role holder has all permissions. */
  static Role roleOf(@Nullable Object of) {
    return of instanceof RoleHolder trusted ? trusted.role() : Role.OWNER;
  }
}
