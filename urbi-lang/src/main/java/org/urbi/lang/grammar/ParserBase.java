package org.urbi.lang.grammar;

import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.TokenStream;
import org.urbi.lang.grammar.UrbiscriptParser.AssignmentContext;

/** Bounds the depth of what is parsed, since the parser is recursive. */
public abstract class ParserBase extends Parser {
  /** How many rules may be open at once: some three hundred nested scopes. */
  static final int MAXIMUM_DEPTH = 3000;

  private int open;
  private Checkpoint checkpoint = Checkpoint.NONE;

  protected ParserBase(TokenStream input) {
    super(input);
  }

  /** Sets what is passed at the beginning of each rule. */
  public void setCheckpoint(Checkpoint passed) {
    checkpoint = passed;
  }

  /** Whether an expression may stand before a colon: it has no operators but assignment. */
  protected static boolean isTag(ParserRuleContext expression) {
    return expression == null
        || expression.getChildCount() == 1
        || (expression.getChildCount() == 2 && expression.getChild(1) instanceof AssignmentContext);
  }

  /** Whether an operand is anything but a scope. */
  protected static boolean isNoScope(ParserRuleContext operand) {
    return operand == null || operand.getStart().getType() != UrbiscriptParser.LBRACE;
  }

  @Override
  public void enterRule(ParserRuleContext context, int state, int ruleIndex) {
    super.enterRule(context, state, ruleIndex);
    checkpoint.pass();
    if (++open > MAXIMUM_DEPTH) {
      throw new NestingException(_input.LT(1));
    }
  }

  @Override
  public void exitRule() {
    open--;
    super.exitRule();
  }
}
