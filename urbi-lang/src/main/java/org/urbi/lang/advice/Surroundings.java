package org.urbi.lang.advice;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.grammar.LexicalError;
import org.urbi.lang.grammar.TextStream;
import org.urbi.lang.grammar.UrbiscriptLexer;
import org.urbi.lang.source.Source;
import org.urbi.lang.source.Span;

/** The tokens around a mistake, and the brackets that are open there. */
final class Surroundings {
  private static final Set<Integer> SEPARATORS =
      Set.of(
          UrbiscriptLexer.SEMICOLON,
          UrbiscriptLexer.COMMA,
          UrbiscriptLexer.PIPE,
          UrbiscriptLexer.AND,
          UrbiscriptLexer.LBRACE,
          UrbiscriptLexer.RBRACE);

  private final Source source;
  private final List<Token> tokens = new ArrayList<>();
  private final List<LexicalError> issues;
  private final Deque<OpenBracket> open = new ArrayDeque<>();
  private final int at;
  private @Nullable OpenBracket suspect;
  private int suspectCloser = -1;

  /**
   * Looks at a text.
   *
   * @param place the offset of the mistake
   */
  Surroundings(Source source, int place) {
    this.source = source;
    var lexer = new UrbiscriptLexer(new TextStream(source.text(), 0, source.text().length()));
    Token token = lexer.nextToken();
    while (token.getType() != Token.EOF) {
      tokens.add(token);
      token = lexer.nextToken();
    }
    tokens.add(token);
    issues = lexer.issues();
    int index = 0;
    while (index < tokens.size() - 1 && tokens.get(index).getStartIndex() < place) {
      pass(index++);
    }
    at = index;
  }

  /** Keeps the brackets that are open behind a token. */
  private void pass(int index) {
    switch (type(index)) {
      case UrbiscriptLexer.LBRACE -> open.push(new OpenBracket(index, '{'));
      case UrbiscriptLexer.LPAREN -> open.push(new OpenBracket(index, '('));
      case UrbiscriptLexer.LBRACKET -> open.push(new OpenBracket(index, '['));
      case UrbiscriptLexer.RBRACE -> closeBrace(index);
      case UrbiscriptLexer.RPAREN, UrbiscriptLexer.RBRACKET -> {
        if (!open.isEmpty() && open.getFirst().mark() != '{') {
          open.pop();
        }
      }
      default -> {}
    }
  }

  /**
   * A brace at the beginning of a line that is indented less than the line of the brace that it
   * closes was meant to close another one: the one inside is not closed.
   */
  private void closeBrace(int closer) {
    if (open.isEmpty()) {
      return;
    }
    OpenBracket opener = open.pop();
    if (suspect == null
        && beginsLine(closer)
        && !sameLine(opener.token(), closer)
        && indentation(closer) < indentation(opener.token())) {
      suspect = opener;
      suspectCloser = closer;
    }
  }

  /** The mistakes of the scanner in the text. */
  List<LexicalError> issues() {
    return issues;
  }

  /** The index of the token at the mistake. */
  int at() {
    return at;
  }

  /** The type of a token; {@link Token#EOF} outside of the text. */
  int type(int index) {
    return index < 0 || index >= tokens.size() ? Token.EOF : tokens.get(index).getType();
  }

  boolean is(int index, int... types) {
    int type = type(index);
    for (int one : types) {
      if (type == one) {
        return true;
      }
    }
    return false;
  }

  String text(int index) {
    return type(index) == Token.EOF ? "" : tokens.get(index).getText();
  }

  Span span(int index) {
    Token token = tokens.get(index);
    int begin = Math.min(token.getStartIndex(), source.text().length());
    return new Span(source, begin, Math.max(begin, token.getStopIndex() + 1));
  }

  Span span(LexicalError issue) {
    return new Span(source, issue.begin(), Math.min(issue.end(), issue.begin() + 1));
  }

  /** The innermost bracket that is open at the mistake, or null. */
  @Nullable OpenBracket innermost() {
    return open.peekFirst();
  }

  /** The bracket that is not closed, as far as the indentation tells, or null. */
  @Nullable OpenBracket suspect() {
    return suspect;
  }

  /** What closed it by mistake. */
  int suspectCloser() {
    return suspectCloser;
  }

  /** Whether a bracket has a token of a type before the mistake, not within other brackets. */
  boolean holds(OpenBracket bracket, int type) {
    int depth = 0;
    for (int i = bracket.token() + 1; i < at; i++) {
      if (is(i, UrbiscriptLexer.LPAREN, UrbiscriptLexer.LBRACKET, UrbiscriptLexer.LBRACE)) {
        depth++;
      } else if (is(i, UrbiscriptLexer.RPAREN, UrbiscriptLexer.RBRACKET, UrbiscriptLexer.RBRACE)) {
        depth--;
      } else if (depth == 0 && is(i, type)) {
        return true;
      }
    }
    return false;
  }

  /** The first token of the statement in which a token is. */
  int statement(int index) {
    int first = index;
    int depth = 0;
    while (first > 0) {
      int before = type(first - 1);
      if (before == UrbiscriptLexer.RPAREN || before == UrbiscriptLexer.RBRACKET) {
        depth++;
      } else if (before == UrbiscriptLexer.LPAREN || before == UrbiscriptLexer.LBRACKET) {
        depth--;
      }
      if (depth < 0 || depth == 0 && SEPARATORS.contains(before)) {
        return first;
      }
      first--;
    }
    return first;
  }

  /** The text behind a token; that of the whole source for an index before the first. */
  String behind(int index) {
    return index < 0 ? source.text() : source.text().substring(span(index).end());
  }

  /** The text before a token, at most so many characters. */
  String before(int index, int length) {
    int end = span(index).begin();
    return source.text().substring(Math.max(0, end - length), end);
  }

  /** Whether two tokens stand next to each other, without space. */
  boolean touch(int first) {
    return first >= 0
        && first + 1 < tokens.size()
        && tokens.get(first).getStopIndex() + 1 == tokens.get(first + 1).getStartIndex();
  }

  boolean sameLine(int first, int second) {
    return line(first) == line(second);
  }

  /** The number of the line, as it is shown, in which a token ends. */
  int lastLine(int index) {
    return span(index).location().endLine();
  }

  int line(int index) {
    return span(index).location().line();
  }

  /** Whether only white space stands before a token in its line. */
  boolean beginsLine(int index) {
    int begin = span(index).begin();
    return source.text().substring(lineBegin(begin), begin).isBlank();
  }

  private int indentation(int index) {
    int begin = lineBegin(span(index).begin());
    int end = begin;
    while (end < source.text().length() && " \t".indexOf(source.text().charAt(end)) >= 0) {
      end++;
    }
    return end - begin;
  }

  private int lineBegin(int offset) {
    return source.text().lastIndexOf('\n', offset - 1) + 1;
  }
}
