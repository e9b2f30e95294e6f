package org.urbi.lang.grammar;

import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.TokenStream;

/** A parser that refuses to nest without end. */
public abstract class ParserBase extends Parser {
  /** Rules inside each other; some five of them for a pair of parentheses. */
  private static final int LIMIT = 3000;

  private int depth;

  protected ParserBase(TokenStream input) {
    super(input);
  }

  @Override
  public void reset() {
    super.reset();
    depth = 0;
  }

  @Override
  public void enterRule(ParserRuleContext context, int state, int rule) {
    deeper();
    super.enterRule(context, state, rule);
  }

  @Override
  public void exitRule() {
    super.exitRule();
    depth--;
  }

  @Override
  public void enterRecursionRule(ParserRuleContext context, int state, int rule, int precedence) {
    deeper();
    super.enterRecursionRule(context, state, rule, precedence);
  }

  @Override
  public void unrollRecursionContexts(ParserRuleContext parent) {
    super.unrollRecursionContexts(parent);
    depth--;
  }

  private void deeper() {
    depth++;
    if (depth > LIMIT) {
      throw new TooDeep(getCurrentToken());
    }
  }

  /** Thrown where the nesting is too deep. */
  public static final class TooDeep extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final transient Token token;

    TooDeep(Token token) {
      super("nesting too deep", null, false, false);
      this.token = token;
    }

    /** The first word that is too deep. */
    public Token token() {
      return token;
    }
  }
}
