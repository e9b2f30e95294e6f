package org.urbi.lang.parse;

import org.urbi.lang.grammar.UrbiscriptParser;

/**
 * The operators, from the loosest to the tightest (manual, "All operators summary").
 *
 * <p>The unary signs bind looser than {@code **}: {@code -2 ** 2} is -4. Comparisons bind tighter
 * than equalities: {@code 2 < 6 === true} (manual, "Boolean"). Neither associate.
 */
enum Operators {
  OR("||", UrbiscriptParser.OR_OR, 1),
  AND("&&", UrbiscriptParser.AND_AND, 2),
  IN("has", UrbiscriptParser.IN, 3),
  NOT_IN("hasNot", UrbiscriptParser.NOT, 3),
  NOT("!", UrbiscriptParser.BANG, 4),
  BITOR("bitor", UrbiscriptParser.BITOR, 5),
  XOR("^", UrbiscriptParser.XOR, 6),
  BITAND("bitand", UrbiscriptParser.BITAND, 7),
  EQUAL("==", UrbiscriptParser.EQUAL, 8),
  NOT_EQUAL("!=", UrbiscriptParser.NOT_EQUAL, 8),
  SAME("===", UrbiscriptParser.SAME, 8),
  NOT_SAME("!==", UrbiscriptParser.NOT_SAME, 8),
  NEAR("~=", UrbiscriptParser.NEAR, 8),
  NEAR_ABSOLUTE("=~=", UrbiscriptParser.NEAR_ABSOLUTE, 8),
  LESS("<", UrbiscriptParser.LESS, 9),
  LESS_EQUAL("<=", UrbiscriptParser.LESS_EQUAL, 9),
  GREATER(">", UrbiscriptParser.GREATER, 9),
  GREATER_EQUAL(">=", UrbiscriptParser.GREATER_EQUAL, 9),
  SHIFT_LEFT("<<", UrbiscriptParser.SHIFT_LEFT, 10),
  SHIFT_RIGHT(">>", UrbiscriptParser.SHIFT_RIGHT, 10),
  ADD("+", UrbiscriptParser.PLUS, 11),
  SUBTRACT("-", UrbiscriptParser.MINUS, 11),
  MULTIPLY("*", UrbiscriptParser.TIMES, 12),
  DIVIDE("/", UrbiscriptParser.DIVIDE, 12),
  MODULO("%", UrbiscriptParser.MODULO, 12),
  PLUS("+", UrbiscriptParser.PLUS, 13),
  MINUS("-", UrbiscriptParser.MINUS, 13),
  COMPL("compl", UrbiscriptParser.COMPL, 13),
  POWER("**", UrbiscriptParser.POWER, 14);

  private static final Operators[] BINARY = new Operators[256];

  static {
    for (Operators operator : values()) {
      if (operator != NOT && operator.precedence != 13) {
        BINARY[operator.token] = operator;
      }
    }
  }

  /** The message that the operator sends. */
  final String text;

  final int precedence;

  /** Whether {@code a OP b OP c} means something. */
  final boolean chainable;

  final boolean rightAssociative;

  private final int token;

  Operators(String text, int token, int precedence) {
    this.text = text;
    this.token = token;
    this.precedence = precedence;
    this.chainable = precedence != 9 && precedence != 8 && precedence != 3;
    this.rightAssociative = precedence == 14;
  }

  /** The binary operator that starts with a token; {@code not} starts {@code not in}. */
  static Operators binary(int token) {
    return BINARY[token];
  }

  /** The prefix operator that is a token. */
  static Operators prefix(int token) {
    return switch (token) {
      case UrbiscriptParser.PLUS -> PLUS;
      case UrbiscriptParser.MINUS -> MINUS;
      case UrbiscriptParser.BANG, UrbiscriptParser.NOT -> NOT;
      default -> COMPL;
    };
  }
}
