package org.urbi.lang.grammar;

import org.antlr.v4.runtime.CharStream;
import org.antlr.v4.runtime.IntStream;
import org.antlr.v4.runtime.Lexer;

/** The words that count: strings with verbatim bytes, and comments that nest. */
public abstract class LexerBase extends Lexer {
  protected LexerBase(CharStream input) {
    super(input);
  }

  /** Goes to the end of a string, its opening quote being read. */
  protected void string() {
    while (true) {
      int c = read();
      if (c == IntStream.EOF) {
        setType(UrbiLexer.BAD_STRING);
        return;
      } else if (c == '"') {
        return;
      } else if (c == '\\' && read() == 'B') {
        blob();
      }
    }
  }

  /** Goes over {@code (size)(bytes)}; stays where it stops to look like that. */
  private void blob() {
    int at = 1;
    if (_input.LA(at) != '(') {
      return;
    }
    long size = 0;
    at++;
    while (_input.LA(at) >= '0' && _input.LA(at) <= '9') {
      size = Math.min(size * 10 + _input.LA(at) - '0', Integer.MAX_VALUE);
      at++;
    }
    if (at == 2 || _input.LA(at) != ')' || _input.LA(at + 1) != '(') {
      return;
    }
    for (long i = 0; i < at + 1 + size && read() != IntStream.EOF; i++) {}
  }

  /** Goes to the end of a comment, its opening being read. */
  protected void comment() {
    int depth = 1;
    while (depth > 0) {
      int c = read();
      if (c == IntStream.EOF) {
        return;
      } else if (c == '/' && _input.LA(1) == '*') {
        read();
        depth++;
      } else if (c == '*' && _input.LA(1) == '/') {
        read();
        depth--;
      }
    }
  }

  private int read() {
    int c = _input.LA(1);
    if (c != IntStream.EOF) {
      _input.consume();
    }
    return c;
  }
}
