package org.urbi.kernel.trust;

import org.jspecify.annotations.Nullable;

/** What the code of a lobby may do; each may do what those before it may (docs/networking.md). */
public enum Role {
  /** Reads and subscribes, and changes nothing but what is its own. */
  OBSERVER,

  /** Changes what neither the system nor another lobby has; files below a directory only. */
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
