package org.urbi.lang.highlight;

import java.util.ArrayList;
import java.util.List;
import org.antlr.v4.runtime.Token;
import org.urbi.lang.grammar.Keywords;
import org.urbi.lang.grammar.TextStream;
import org.urbi.lang.grammar.UrbiscriptLexer;

/** Takes a text apart as the scanner of the language does, and keeps what that one skips. */
public final class Pieces {
  private static final class Scanner extends UrbiscriptLexer {
    private final String text;
    private final List<Piece> pieces = new ArrayList<>();

    Scanner(String text) {
      super(new TextStream(text, 0, text.length()));
      this.text = text;
      removeErrorListeners();
    }

    @Override
    public void skip() {
      super.skip();
      char first = text.charAt(_tokenStartCharIndex);
      if (first == '/') {
        add(Kind.COMMENT, _tokenStartCharIndex, getInputStream().index());
      } else if (!Character.isWhitespace(first)) {
        add(Kind.REFUSED, _tokenStartCharIndex, getInputStream().index());
      }
    }

    void scan() {
      for (Token token = nextToken(); token.getType() != Token.EOF; token = nextToken()) {
        int begin = token.getStartIndex();
        int end = token.getStopIndex() + 1;
        // A binary literal at top level is followed by a separator that nobody wrote.
        if (begin < end) {
          add(kind(token.getType(), text.substring(begin, end)), begin, end);
        }
      }
    }

    private void add(Kind kind, int begin, int end) {
      pieces.add(new Piece(kind, begin, end));
    }
  }

  private Pieces() {}

  /**
   * The pieces of a text, in their order: all of it but the blanks, whatever is wrong with it.
   *
   * @param text a program, or a part of one
   */
  public static List<Piece> of(String text) {
    Scanner scanner = new Scanner(text);
    scanner.scan();
    return List.copyOf(scanner.pieces);
  }

  private static Kind kind(int type, String text) {
    return switch (type) {
      case UrbiscriptLexer.STRING -> Kind.STRING;
      case UrbiscriptLexer.DURATION -> Kind.DURATION;
      case UrbiscriptLexer.NUMBER -> angle(text) ? Kind.ANGLE : Kind.NUMBER;
      case UrbiscriptLexer.QUOTED, UrbiscriptLexer.DERIVED -> Kind.NAME;
      case UrbiscriptLexer.BINARY -> Kind.BINARY;
      case UrbiscriptLexer.INVALID -> Kind.INVALID;
      default ->
          Character.isLetter(text.charAt(0)) || text.charAt(0) == '_' ? word(text) : Kind.SYMBOL;
    };
  }

  private static boolean angle(String number) {
    return number.endsWith("rad") || number.endsWith("deg");
  }

  private static Kind word(String word) {
    if (Keywords.all().contains(word)) {
      return Keywords.keyword(word) ? Kind.KEYWORD : Kind.CONTEXTUAL;
    }
    return Keywords.keyword(word) ? Kind.REFUSED : Kind.NAME;
  }
}
