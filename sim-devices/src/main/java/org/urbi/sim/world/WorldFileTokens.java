package org.urbi.sim.world;

import java.util.ArrayList;
import java.util.List;
import org.urbi.sim.world.WorldFileException.Place;

/** Cuts the text of a world file into words, numbers, strings, braces and ends of properties. */
final class WorldFileTokens {
  enum Kind {
    WORD,
    NUMBER,
    STRING,
    OPEN,
    CLOSE,
    /** A semicolon or the end of a line. */
    END_OF_PROPERTY,
    END_OF_FILE
  }

  record Token(Kind kind, String text, double number, Place place) {
    /** As a message shows it. */
    String shown() {
      return switch (kind) {
        case END_OF_PROPERTY -> "the end of the line";
        case END_OF_FILE -> "the end of the file";
        default -> "'" + text + "'";
      };
    }
  }

  private final String file;
  private final String text;
  private int at;
  private int line = 1;
  private int lineStart;
  private final List<Token> tokens = new ArrayList<>();

  private WorldFileTokens(String file, String text) {
    this.file = file;
    this.text = text;
  }

  static List<Token> of(String file, String text) {
    return new WorldFileTokens(file, text).cut();
  }

  private Place place() {
    return new Place(file, line, at - lineStart + 1);
  }

  private void add(Kind kind, String shown, double number, Place place) {
    tokens.add(new Token(kind, shown, number, place));
  }

  private List<Token> cut() {
    while (at < text.length()) {
      char c = text.charAt(at);
      Place place = place();
      switch (c) {
        case '\n', ';' -> {
          add(Kind.END_OF_PROPERTY, String.valueOf(c), 0, place);
          at++;
          if (c == '\n') {
            line++;
            lineStart = at;
          }
        }
        case ' ', '\t', '\r', ',' -> at++;
        case '#' -> at = endOfLine();
        case '{' -> {
          add(Kind.OPEN, "{", 0, place);
          at++;
        }
        case '}' -> {
          add(Kind.CLOSE, "}", 0, place);
          at++;
        }
        case '"' -> string(place);
        default -> wordOrNumber(place);
      }
    }
    add(Kind.END_OF_FILE, "", 0, place());
    return tokens;
  }

  private int endOfLine() {
    int end = text.indexOf('\n', at);
    return end < 0 ? text.length() : end;
  }

  private void string(Place place) {
    int end = text.indexOf('"', at + 1);
    if (end < 0 || end > endOfLine()) {
      throw new WorldFileException(place, "the string does not end on its line");
    }
    add(Kind.STRING, text.substring(at + 1, end), 0, place);
    at = end + 1;
  }

  private void wordOrNumber(Place place) {
    int start = at;
    while (at < text.length() && isWordPart(text.charAt(at))) {
      at++;
    }
    if (at == start) {
      int c = text.codePointAt(at);
      throw new WorldFileException(place, "unexpected character '" + Character.toString(c) + "'");
    }
    String word = text.substring(start, at);
    char first = word.charAt(0);
    if (Character.isLetter(first) || first == '_') {
      add(Kind.WORD, word, 0, place);
      return;
    }
    try {
      add(Kind.NUMBER, word, Double.parseDouble(word), place);
    } catch (NumberFormatException e) {
      throw new WorldFileException(place, "neither a number nor a name: '" + word + "'");
    }
  }

  private static boolean isWordPart(char c) {
    return Character.isLetterOrDigit(c) || "_.-+[]".indexOf(c) >= 0;
  }
}
