package org.urbi.lang.grammar;

import org.antlr.v4.runtime.CharStream;
import org.antlr.v4.runtime.CommonToken;
import org.antlr.v4.runtime.TokenSource;
import org.antlr.v4.runtime.misc.Pair;

/** A token with what it stands for: a number, or the contents of a string or of a quoted name. */
public final class UrbiToken extends CommonToken {
  private static final long serialVersionUID = 1;

  private final transient Object value;

  UrbiToken(
      Pair<TokenSource, CharStream> source,
      int type,
      int channel,
      int start,
      int stop,
      Object value) {
    super(source, type, channel, start, stop);
    this.value = value;
  }

  /** The number of a NUMBER or DURATION. */
  public double number() {
    return (Double) value;
  }

  /** The contents of a STRING or a name: what is between the quotes, escapes resolved. */
  public String string() {
    return value == null ? getText() : (String) value;
  }

  /** The contents of a BINARY. */
  public BinaryLiteral binary() {
    return (BinaryLiteral) value;
  }
}
