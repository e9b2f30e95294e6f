package org.urbi.server.trust;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.trust.Role;

/**
 * Who is let in over the network.
 *
 * @param tokens what clients may show; null when nobody is asked
 * @param otherwise the role of those who show none; null when they are not let in
 */
public record AccessPolicy(@Nullable Tokens tokens, @Nullable Role otherwise) {
  /** Everybody is let in and may do everything. */
  public static final AccessPolicy ALL = new AccessPolicy(null, Role.OWNER);

  /** Who shows that token; null if nobody does. */
  public Tokens.@Nullable TokenHolder holder(String token) {
    return tokens == null ? null : tokens.holder(token);
  }

  /** Whether clients are asked for tokens. */
  public boolean asks() {
    return tokens != null;
  }
}
