package org.urbi.lang.parse;

import static java.util.Objects.requireNonNull;

import org.antlr.v4.runtime.RecognitionException;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.TokenStream;
import org.antlr.v4.runtime.misc.ParseCancellationException;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.grammar.UrbiscriptParser;
import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.source.Source;

/**
 * The error for an unexpected token: it names the token and, if there are only a few, the tokens
 * that would have been possible.
 */
final class UnexpectedToken {
  private UnexpectedToken() {}

  static SyntaxError error(Source source, ParseCancellationException stop) {
    var cause =
        (RecognitionException)
            requireNonNull(stop.getCause(), "the parser says what it gave up for");
    Token token = cause.getOffendingToken();
    Token before = before(cause, token);
    int rule = cause.getCtx() == null ? -1 : cause.getCtx().getRuleIndex();
    if (rule == UrbiscriptParser.RULE_modifier && before != null) {
      // Two names in a row: the second would be the modifier of a trajectory, but no colon follows.
      return TokenNames.unexpected(source, before).error();
    }
    String expected = before == null ? null : expected(before.getType(), rule);
    if (expected == null) {
      return TokenNames.unexpected(source, token).error();
    }
    return SyntaxError.of(
        TokenNames.span(source, token),
        SyntaxProblem.UNEXPECTED_INSTEAD,
        TokenNames.name(token),
        expected);
  }

  private static @Nullable Token before(RecognitionException cause, Token token) {
    return token.getTokenIndex() > 0 && cause.getInputStream() instanceof TokenStream tokens
        ? tokens.get(token.getTokenIndex() - 1)
        : null;
  }

  /** What may follow a token; null when that is a lot. */
  private static @Nullable String expected(int before, int rule) {
    return switch (before) {
      case UrbiscriptParser.RBRACE ->
          rule == UrbiscriptParser.RULE_item || rule == UrbiscriptParser.RULE_program
              ? "end of command or \",\" or ;"
              : null;
      case UrbiscriptParser.AND -> rule == UrbiscriptParser.RULE_name ? "identifier or new" : null;
      case UrbiscriptParser.FUNCTION -> "{ or ( or identifier or this";
      case UrbiscriptParser.CLOSURE, UrbiscriptParser.DO -> "{ or (";
      case UrbiscriptParser.TRY, UrbiscriptParser.FINALLY -> "{";
      default -> null;
    };
  }
}
