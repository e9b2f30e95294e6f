package org.urbi.lang.grammar;

import org.antlr.v4.runtime.Token;

/** The text nests deeper than the parser goes. */
public final class NestingException extends RuntimeException {
  private static final long serialVersionUID = 1;

  private final transient Token token;

  NestingException(Token token) {
    super(null, null, false, false);
    this.token = token;
  }

  /** Where the parser gave up. */
  public Token token() {
    return token;
  }
}
