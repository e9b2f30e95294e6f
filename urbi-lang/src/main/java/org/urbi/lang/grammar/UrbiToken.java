package org.urbi.lang.grammar;

import static java.util.Objects.requireNonNull;

import org.antlr.v4.runtime.CharStream;
import org.antlr.v4.runtime.CommonToken;
import org.antlr.v4.runtime.TokenSource;
import org.antlr.v4.runtime.misc.Pair;
import org.jspecify.annotations.Nullable;

/** A token with what it stands for: a number, or the contents of a string or of a quoted name. */
public final class UrbiToken extends CommonToken {
  private static final long serialVersionUID = 1;

  private static final String NO_LITERAL = "a token of another type has no value";

  private final transient @Nullable Object value;

  UrbiToken(
      Pair<TokenSource, CharStream> source,
      int type,
      int channel,
      int start,
      int stop,
      @Nullable Object value) {
    super(source, type, channel, start, stop);
    this.value = value;
  }

  /** The number of a NUMBER or DURATION. */
  public double number() {
    return (Double) requireNonNull(value, NO_LITERAL);
  }

  /** The contents of a STRING or a name: what is between the quotes, escapes resolved. */
  public String string() {
    return value == null ? getText() : (String) value;
  }

  /** The contents of a BINARY. */
  public BinaryLiteral binary() {
    return (BinaryLiteral) requireNonNull(value, NO_LITERAL);
  }
}
