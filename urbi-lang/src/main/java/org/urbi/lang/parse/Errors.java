package org.urbi.lang.parse;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.urbi.lang.source.Source;
import org.urbi.lang.source.Span;

/** What was wrong in one text, and the spans of its pieces. */
final class Errors {
  private final Source source;
  private final List<SyntaxError> errors = new ArrayList<>();

  Errors(Source source) {
    this.source = source;
  }

  void add(Span span, String message) {
    errors.add(new SyntaxError(span, "syntax error: " + message));
  }

  boolean isEmpty() {
    return errors.isEmpty();
  }

  /** In the order of the text. */
  List<SyntaxError> sorted() {
    return errors.stream()
        .sorted(Comparator.comparingInt((SyntaxError e) -> e.span().begin()))
        .toList();
  }

  Span span(int begin, int end) {
    return new Span(source, begin, end);
  }

  Span span(Token token) {
    int length = source.text().length();
    if (token.getType() == Token.EOF) {
      return span(length, length);
    }
    return span(token.getStartIndex(), token.getStopIndex() + 1);
  }

  Span span(ParserRuleContext context) {
    int begin = Math.min(context.getStart().getStartIndex(), source.text().length());
    Token stop = context.getStop();
    return span(begin, stop == null ? begin : Math.max(begin, stop.getStopIndex() + 1));
  }

  Span span(Token first, Token last) {
    return span(first).to(span(last));
  }
}
