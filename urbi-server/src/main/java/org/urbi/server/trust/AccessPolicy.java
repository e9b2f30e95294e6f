package org.urbi.server.trust;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.trust.Role;

/**
 * Which clients of the network are accepted, with which roles, and how.
 *
 * @param tokens what clients may show; null when nobody is asked
 * @param defaultRole the role of those who show none; null when they are not let in
 * @param identity what the server shows by TLS; null without TLS
 */
public record AccessPolicy(
    @Nullable Tokens tokens, @Nullable Role defaultRole, @Nullable ServerIdentity identity) {
  /** Accepts everybody, with the role owner. */
  public static final AccessPolicy ALL = new AccessPolicy(null, Role.OWNER);

  /** Without TLS. */
  public AccessPolicy(@Nullable Tokens tokens, @Nullable Role defaultRole) {
    this(tokens, defaultRole, null);
  }

  /** The holder of that token; null if it is unknown. */
  public Tokens.@Nullable TokenHolder holder(String token) {
    return tokens == null ? null : tokens.holder(token);
  }

  /** Whether clients are asked for tokens. */
  public boolean asks() {
    return tokens != null;
  }
}
