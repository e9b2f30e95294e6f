package org.urbi.server.trust;

import org.urbi.kernel.trust.Role;

/**
 * Who is let in over the network.
 *
 * @param tokens what clients may show; null when nobody is asked
 * @param otherwise the role of those who show none; null when they are not let in
 */
public record Admission(Tokens tokens, Role otherwise) {
  /** Everybody is let in and may do everything. */
  public static final Admission ALL = new Admission(null, Role.OWNER);

  /** Whether clients are asked for tokens. */
  public boolean asks() {
    return tokens != null;
  }
}
