package org.urbi.lang.parse;

import org.antlr.v4.runtime.Token;
import org.urbi.lang.grammar.UrbiscriptLexer;
import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.source.Source;
import org.urbi.lang.source.Span;

/** How error messages call tokens. */
final class TokenNames {
  private TokenNames() {}

  static SyntaxErrorException unexpected(Source source, Token token) {
    return new SyntaxErrorException(span(source, token), SyntaxProblem.UNEXPECTED, name(token));
  }

  static Span span(Source source, Token token) {
    int begin = Math.min(token.getStartIndex(), source.text().length());
    return new Span(source, begin, Math.max(begin, token.getStopIndex() + 1));
  }

  static String name(Token token) {
    return switch (token.getType()) {
      case Token.EOF -> "end of file";
      case UrbiscriptLexer.WORD, UrbiscriptLexer.QUOTED -> "identifier";
      case UrbiscriptLexer.NUMBER -> "float";
      case UrbiscriptLexer.DURATION -> "duration";
      case UrbiscriptLexer.STRING -> "string";
      case UrbiscriptLexer.BINARY -> "binary";
      case UrbiscriptLexer.SEMICOLON -> ";";
      default -> token.getText();
    };
  }
}
