package org.urbi.lang.parse;

import org.urbi.lang.grammar.QuickTokens;
import org.urbi.lang.grammar.UrbiscriptParser;
import org.urbi.lang.source.Source;
import org.urbi.lang.source.Span;

/** Where the quick parser is in its tokens, and what is around that place. */
final class QuickCursor {
  /** Deeper nesting is left to the other parser, which knows how deep is too deep. */
  private static final int MAXIMUM_HEIGHT = 200;

  /** Tells that there is something which the quick parser does not know. */
  static final class UnusualException extends RuntimeException {
    private static final long serialVersionUID = 1;
    private static final UnusualException IT = new UnusualException();

    private UnusualException() {
      super(null, null, false, false);
    }
  }

  private final Source source;
  private final QuickTokens tokens;
  private final int[] types;
  private int at;
  private int height;

  /** Whether declarations may stand in lists, for they are what a pattern binds. */
  boolean pattern;

  int enclosingFunctions;
  int enclosingLoops;
  int enclosingCatches;

  QuickCursor(Source source, QuickTokens tokens) {
    this.source = source;
    this.tokens = tokens;
    this.types = tokens.types();
  }

  /** To be thrown at what is unusual. */
  static UnusualException unusual() {
    return UnusualException.IT;
  }

  /** The type of the next token. */
  int type() {
    return types[at];
  }

  /** The type of the token behind the next one, which is not the last. */
  int typeAfter() {
    return types[at + 1];
  }

  boolean is(int type) {
    return types[at] == type;
  }

  /** Reads the next token, whatever it is; its index. */
  int next() {
    return at++;
  }

  /** Goes back to a token that was read. */
  void back(int index) {
    at = index;
  }

  /** Reads the next token if it is of that type. */
  boolean skip(int type) {
    if (types[at] == type) {
      at++;
      return true;
    }
    return false;
  }

  /** Reads the next token, which must be of that type. */
  void expect(int type) {
    if (types[at++] != type) {
      throw unusual();
    }
  }

  /**
   * Whether another element of a list follows: reads the comma before it, or what closes the list.
   * A comma behind the last element is allowed.
   *
   * @param first whether none has been read yet
   */
  boolean isMore(boolean first, int closing) {
    if (skip(closing)) {
      return false;
    }
    if (!first) {
      expect(UrbiscriptParser.COMMA);
      return !skip(closing);
    }
    return true;
  }

  QuickTokens tokens() {
    return tokens;
  }

  /** Where the next token begins. */
  int begin() {
    return tokens.begin(at);
  }

  /** From an offset to the end of the last token that was read; empty if none was since. */
  Span span(int begin) {
    return new Span(source, begin, Math.max(begin, end()));
  }

  /** An empty piece. */
  Span nothing(int offset) {
    return new Span(source, offset, offset);
  }

  /** The end of the last token that was read. */
  int end() {
    return at == 0 ? 0 : tokens.end(at - 1);
  }

  /** Where a token is. */
  Span token(int index) {
    return new Span(source, tokens.begin(index), tokens.end(index));
  }

  /** Something begins that is nested, until {@link #leave}. */
  void enter() {
    if (++height > MAXIMUM_HEIGHT) {
      throw unusual();
    }
  }

  /** The height now, to come back to. */
  int height() {
    return height;
  }

  void leave(int before) {
    height = before;
  }

  boolean isName() {
    return isName(type());
  }

  /** Whether a name, or {@code this}, follows the token. */
  boolean isBeforeName() {
    int after = typeAfter();
    return isName(after) || after == UrbiscriptParser.THIS;
  }

  /** Whether a token can be the name of a slot behind a dot. */
  static boolean isName(int type) {
    return isIdentifier(type)
        || type == UrbiscriptParser.NEW
        || type == UrbiscriptParser.WATCH
        || type == UrbiscriptParser.EMIT;
  }

  /** Whether a token can be a name that stands alone. */
  static boolean isIdentifier(int type) {
    return type == UrbiscriptParser.WORD
        || type == UrbiscriptParser.QUOTED
        || type == UrbiscriptParser.GET
        || type == UrbiscriptParser.SET
        || type == UrbiscriptParser.IMPORT
        || type == UrbiscriptParser.PACKAGE;
  }

  /** Reads a name; its index. */
  int name() {
    if (!isName()) {
      throw unusual();
    }
    return at++;
  }

  /** Whether no statement stands here, where one may be left out. */
  boolean isEndOfStatement() {
    return switch (type()) {
      case UrbiscriptParser.SEMICOLON,
          UrbiscriptParser.COMMA,
          UrbiscriptParser.PIPE,
          UrbiscriptParser.RBRACE,
          UrbiscriptParser.RPAREN,
          UrbiscriptParser.CASE,
          UrbiscriptParser.DEFAULT,
          UrbiscriptParser.EOF ->
          true;
      // Either a separator, or the beginning of "&name".
      case UrbiscriptParser.AND -> throw unusual();
      default -> false;
    };
  }
}
