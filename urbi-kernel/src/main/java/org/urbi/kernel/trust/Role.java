package org.urbi.kernel.trust;

import org.jspecify.annotations.Nullable;

/**
 * The permissions of a lobby's code; each role includes those of the roles before it
 * (docs/networking.md).
 */
public enum Role {
  /** May read and subscribe, but only change its own objects. */
  OBSERVER,

  /**
   * May change objects that belong neither to the system nor to another lobby, and use files below
   * one directory.
   */
  USER,

  /** Everything. */
  OWNER;

  private final String text = name().toLowerCase(java.util.Locale.ROOT);

  /** The role of that name: {@code owner}, {@code user}, {@code observer}; null if unknown. */
  public static @Nullable Role of(String name) {
    for (Role role : values()) {
      if (role.text.equals(name)) {
        return role;
      }
    }
    return null;
  }

  /** Its name, as people write it. */
  public String text() {
    return text;
  }
}
