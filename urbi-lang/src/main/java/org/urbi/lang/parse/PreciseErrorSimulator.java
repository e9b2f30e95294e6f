package org.urbi.lang.parse;

import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.atn.ATN;
import org.antlr.v4.runtime.atn.ATNConfigSet;
import org.antlr.v4.runtime.atn.ParserATNSimulator;
import org.antlr.v4.runtime.atn.PredictionMode;

/**
 * Blames the token at which no way is left. ANTLR would rather leave the rule before the decision,
 * and blame the token at which it began, because that serves error recovery.
 */
final class PreciseErrorSimulator extends ParserATNSimulator {
  PreciseErrorSimulator(Parser parser, PredictionMode mode) {
    super(
        parser,
        parser.getATN(),
        parser.getInterpreter().decisionToDFA,
        parser.getInterpreter().getSharedContextCache());
    setPredictionMode(mode);
  }

  @Override
  protected int getSynValidOrSemInvalidAltThatFinishedDecisionEntryRule(
      ATNConfigSet configs, ParserRuleContext outerContext) {
    return ATN.INVALID_ALT_NUMBER;
  }
}
