package org.urbi.lang.grammar;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * The tokens of a usual text, read by hand: in a process that has just begun that takes a third of
 * the time of {@code UrbiscriptLexer}, which decides what each token is. Whatever is unusual (an
 * error, a deprecated word, a binary literal) is left to that one.
 */
public final class QuickTokens {
  private static final int UNUSUAL = -1;

  /** Each number of so many digits is a double. */
  private static final int EXACT_DIGITS = 15;

  /** What each word is that is not a plain name. */
  private static final Map<String, Integer> WORDS = words();

  private final String text;

  /** The part that is read: to ask the text for each character would take an interpreter longer. */
  private final char[] characters;

  private final int base;
  private final int last;
  private final Checkpoint checkpoint;
  private int at;
  private int size;
  private int[] types = new int[64];
  private int[] begins = new int[64];
  private int[] ends = new int[64];
  private @Nullable Object[] values = new Object[64];
  private boolean unusual;

  private QuickTokens(String text, int begin, int end, Checkpoint checkpoint) {
    this.text = text;
    this.characters = new char[end - begin];
    this.base = begin;
    this.last = end - begin;
    text.getChars(begin, end, characters, 0);
    this.checkpoint = checkpoint;
  }

  private static Map<String, Integer> words() {
    Map<String, Integer> words = new HashMap<>();
    for (String word : Keywords.all()) {
      words.put(word, Keywords.token(word));
    }
    Keywords.refused().forEach(word -> words.put(word, UNUSUAL));
    for (String word : new String[] {"operator", "BIN", "self", "foreach", "loopn"}) {
      words.put(word, UNUSUAL);
    }
    return words;
  }

  /**
   * The tokens of a part of a text, and the end of file behind them; null if something in it is
   * unusual.
   *
   * @param checkpoint passed before each token
   */
  public static @Nullable QuickTokens read(String text, int begin, int end, Checkpoint checkpoint) {
    QuickTokens tokens = new QuickTokens(text, begin, end, checkpoint);
    return tokens.readAll() ? tokens : null;
  }

  /** The types of the tokens, of {@code UrbiscriptLexer}; what is behind the last is undefined. */
  public int[] types() {
    return types;
  }

  /** The offset of its first character. */
  public int begin(int index) {
    return begins[index];
  }

  /** The offset behind its last character. */
  public int end(int index) {
    return ends[index];
  }

  /** The token as written. */
  public String text(int index) {
    return text.substring(begins[index], ends[index]);
  }

  /** The contents of a string or of a name, escapes resolved. */
  public String string(int index) {
    return values[index] instanceof String string ? string : text(index);
  }

  /** The value of a number, of an angle in radians, of a duration in seconds. */
  public double number(int index) {
    return values[index] instanceof Double number ? number : Double.NaN;
  }

  private boolean readAll() {
    while (!unusual && skipBlanks()) {
      checkpoint.pass();
      next(characters[at]);
    }
    at = last;
    add(UrbiscriptLexer.EOF, last, null);
    return !unusual;
  }

  private void add(int type, int end, @Nullable Object value) {
    if (size == types.length) {
      int room = 2 * size;
      types = Arrays.copyOf(types, room);
      begins = Arrays.copyOf(begins, room);
      ends = Arrays.copyOf(ends, room);
      values = Arrays.copyOf(values, room);
    }
    types[size] = type;
    begins[size] = base + at;
    ends[size] = base + end;
    values[size++] = value;
    at = end;
  }

  /** Skips white space and comments; false at the end of the text. */
  private boolean skipBlanks() {
    while (at < last) {
      char c = characters[at];
      if (c == '/' && is(at + 1, '/')) {
        while (at < last && characters[at] != '\n') {
          at++;
        }
      } else if (c == '/' && is(at + 1, '*')) {
        skipComment();
      } else if (c == ' ' || '\t' <= c && c <= '\r') {
        at++;
      } else {
        return true;
      }
    }
    return false;
  }

  /** Comments nest. */
  private void skipComment() {
    int nesting = 1;
    at += 2;
    while (nesting > 0 && at < last) {
      char c = characters[at++];
      if (c == '*' && is(at, '/')) {
        nesting--;
        at++;
      } else if (c == '/' && is(at, '*')) {
        nesting++;
        at++;
      }
    }
    unusual |= nesting > 0;
  }

  private boolean is(int offset, char expected) {
    return offset < last && characters[offset] == expected;
  }

  private void next(char c) {
    if (Keywords.startsWord(c)) {
      word();
    } else if (Keywords.isDigit(c)) {
      number();
    } else if (c == '"') {
      quoted('"', UrbiscriptLexer.STRING);
    } else if (c == '\'') {
      quoted('\'', UrbiscriptLexer.QUOTED);
    } else {
      symbol(c);
    }
  }

  private int endOfWord(int from) {
    int end = from;
    while (end < last && Keywords.isInWord(characters[end])) {
      end++;
    }
    return end;
  }

  private void word() {
    int end = endOfWord(at + 1);
    String word = text.substring(base + at, base + end);
    int type = WORDS.getOrDefault(word, UrbiscriptLexer.WORD);
    unusual = type == UNUSUAL || is(end, '\'');
    add(type, end, word);
  }

  private int endOfDigits(int from) {
    int end = from;
    while (end < last && (Keywords.isDigit(characters[end]) || characters[end] == '_')) {
      end++;
    }
    return end;
  }

  private boolean digitAt(int offset) {
    return offset < last && Keywords.isDigit(characters[offset]);
  }

  private void number() {
    if (smallNumber()) {
      return;
    }
    int end = endOfDigits(at);
    if (is(end, '.') && digitAt(end + 1)) {
      end = endOfDigits(end + 1);
    }
    if (is(end, 'e') || is(end, 'E')) {
      int exponent = is(end + 1, '+') || is(end + 1, '-') ? end + 2 : end + 1;
      end = digitAt(exponent) ? endOfDigits(exponent) : end;
    }
    end = endOfWord(end);
    String digits = text.substring(base + at, base + end);
    Numbers.Value number = Numbers.parse(digits);
    unusual = number == Numbers.INVALID || digits.charAt(digits.length() - 1) == 'm';
    int type = number.duration() ? UrbiscriptLexer.DURATION : UrbiscriptLexer.NUMBER;
    add(type, end, number.value());
  }

  /**
   * Reads a number of nothing but digits, few enough for a double to be exact; false if it is none.
   */
  private boolean smallNumber() {
    int end = at;
    long value = 0;
    while (end < last && Keywords.isDigit(characters[end])) {
      value = 10 * value + characters[end++] - '0';
    }
    if (end - at > EXACT_DIGITS || is(end, '.') || endOfWord(end) > end) {
      return false;
    }
    add(UrbiscriptLexer.NUMBER, end, (double) value);
    return true;
  }

  private void quoted(char quote, int type) {
    int first = base + at + 1;
    int closing = text.indexOf(quote, first, base + last);
    if (closing >= 0 && text.indexOf('\\', first, closing) < 0) {
      add(type, closing + 1 - base, text.substring(first, closing));
      return;
    }
    var escapes =
        new Escapes(text, first, base + last, quote, (end, problem, about) -> unusual = true);
    boolean closed = escapes.read();
    unusual |= !closed;
    add(type, escapes.position() - base, escapes.value());
  }

  private void symbol(char c) {
    switch (c) {
      case ';' -> add(UrbiscriptLexer.SEMICOLON, at + 1, null);
      case ',' -> add(UrbiscriptLexer.COMMA, at + 1, null);
      case ':' -> add(UrbiscriptLexer.COLON, at + 1, null);
      case '?' -> add(UrbiscriptLexer.QUESTION, at + 1, null);
      case '(' -> add(UrbiscriptLexer.LPAREN, at + 1, null);
      case ')' -> add(UrbiscriptLexer.RPAREN, at + 1, null);
      case '[' -> add(UrbiscriptLexer.LBRACKET, at + 1, null);
      case ']' -> add(UrbiscriptLexer.RBRACKET, at + 1, null);
      case '{' -> add(UrbiscriptLexer.LBRACE, at + 1, null);
      case '}' -> add(UrbiscriptLexer.RBRACE, at + 1, null);
      case '|' -> either(UrbiscriptLexer.PIPE, '|', UrbiscriptLexer.OR_OR);
      case '&' -> either(UrbiscriptLexer.AND, '&', UrbiscriptLexer.AND_AND);
      case '.' -> either(UrbiscriptLexer.DOT, '&', UrbiscriptLexer.DOT_AND);
      case '~' -> either(UrbiscriptLexer.TILDE, '=', UrbiscriptLexer.NEAR);
      case '/' -> either(UrbiscriptLexer.DIVIDE, '=', UrbiscriptLexer.DIVIDE_ASSIGN);
      case '%' -> either(UrbiscriptLexer.MODULO, '=', UrbiscriptLexer.MODULO_ASSIGN);
      case '^' -> either(UrbiscriptLexer.XOR, '=', UrbiscriptLexer.XOR_ASSIGN);
      default -> longSymbol(c);
    }
  }

  private void longSymbol(char c) {
    switch (c) {
      case '+' ->
          oneOf(
              UrbiscriptLexer.PLUS,
              '=',
              UrbiscriptLexer.PLUS_ASSIGN,
              '+',
              UrbiscriptLexer.INCREMENT);
      case '*' ->
          oneOf(
              UrbiscriptLexer.TIMES, '=', UrbiscriptLexer.TIMES_ASSIGN, '*', UrbiscriptLexer.POWER);
      case '<' ->
          oneOf(
              UrbiscriptLexer.LESS,
              '=',
              UrbiscriptLexer.LESS_EQUAL,
              '<',
              UrbiscriptLexer.SHIFT_LEFT);
      case '>' ->
          oneOf(
              UrbiscriptLexer.GREATER,
              '=',
              UrbiscriptLexer.GREATER_EQUAL,
              '>',
              UrbiscriptLexer.SHIFT_RIGHT);
      case '-' -> {
        if (is(at + 1, '>')) {
          add(UrbiscriptLexer.ARROW, at + 2, null);
        } else {
          oneOf(
              UrbiscriptLexer.MINUS,
              '=',
              UrbiscriptLexer.MINUS_ASSIGN,
              '-',
              UrbiscriptLexer.DECREMENT);
        }
      }
      case '=' -> equals();
      case '!' -> {
        if (is(at + 1, '=') && is(at + 2, '=')) {
          add(UrbiscriptLexer.NOT_SAME, at + 3, null);
        } else {
          either(UrbiscriptLexer.BANG, '=', UrbiscriptLexer.NOT_EQUAL);
        }
      }
      default -> unusual = true;
    }
  }

  private void equals() {
    boolean again = is(at + 2, '=');
    if (is(at + 1, '=')) {
      add(again ? UrbiscriptLexer.SAME : UrbiscriptLexer.EQUAL, again ? at + 3 : at + 2, null);
    } else if (is(at + 1, '~') && again) {
      add(UrbiscriptLexer.NEAR_ABSOLUTE, at + 3, null);
    } else {
      either(UrbiscriptLexer.ASSIGN, '>', UrbiscriptLexer.FAT_ARROW);
    }
  }

  /** One character, or two. */
  private void either(int one, char second, int two) {
    boolean both = is(at + 1, second);
    add(both ? two : one, both ? at + 2 : at + 1, null);
  }

  private void oneOf(int one, char second, int two, char other, int otherTwo) {
    if (is(at + 1, second)) {
      add(two, at + 2, null);
    } else {
      either(one, other, otherTwo);
    }
  }
}
