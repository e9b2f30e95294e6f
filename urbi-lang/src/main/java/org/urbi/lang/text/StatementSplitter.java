package org.urbi.lang.text;

import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast.Flavor;
import org.urbi.lang.grammar.BinaryScanner;
import org.urbi.lang.grammar.Keywords;

/**
 * Finds the ends of statements, one character at a time; the input may be cut anywhere.
 *
 * <p>A statement ends with a {@code ;} or a {@code ,} that is in no bracket, string or comment, is
 * no flavor ({@code loop;}) and does not separate prototypes ({@code class A : B, C}). A {@code ;}
 * where none can be, as in {@code f(1;}, ends it, too, because no continuation could make it valid.
 */
public final class StatementSplitter {
  private enum State {
    CODE,
    WORD,
    DERIVED,
    NUMBER,
    SLASH,
    LINE_COMMENT,
    BLOCK_COMMENT,
    QUOTED,
    ESCAPE,
    BINARY_HEADER,
    BINARY
  }

  /** No keyword is longer. */
  private static final int LONGEST_WORD = 16;

  /** No syncline is longer. */
  private static final int LONGEST_SYNCLINE = 4096;

  private final LineTable lines;
  private final Brackets brackets = new Brackets();
  private final StringBuilder collected = new StringBuilder();
  private final EscapeScanner blob = new EscapeScanner();
  private BinaryScanner binary = new BinaryScanner();
  private int binaryRemaining;
  private State state;
  private int offset;
  private boolean blank;
  private boolean flavorMayFollow;

  /** What a parenthesis would begin here. */
  private Brackets.Kind inside;

  private boolean inClassHead;
  private boolean inPrototypes;
  private boolean wholeLine;
  private int commentDepth;
  private char previous;
  private char quote;
  private @Nullable Flavor separator;

  /**
   * @param lines receives lines and synclines as they are read
   */
  public StatementSplitter(LineTable lines) {
    this.lines = lines;
    restart();
  }

  /** A splitter that has read a whole text. */
  public static StatementSplitter over(CharSequence text) {
    var splitter = new StatementSplitter(new LineTable(null, 1));
    int at = 0;
    while (at < text.length()) {
      at = splitter.scan(text, at, text.length(), 0);
    }
    return splitter;
  }

  /** Whether something is unfinished: a statement, or a comment that spans lines. */
  public boolean pending() {
    return !blank || state == State.BLOCK_COMMENT;
  }

  /**
   * What is open at the end of what was read: a quote, the beginning of a comment, or the innermost
   * bracket; empty when nothing is.
   */
  public String open() {
    return switch (state) {
      case QUOTED, ESCAPE -> String.valueOf(quote);
      case BLOCK_COMMENT -> "/*";
      case LINE_COMMENT -> "//";
      default -> brackets.innermost();
    };
  }

  /** The separator of the last statement; null when {@link #scan} reached the end of its text. */
  public @Nullable Flavor separator() {
    return separator;
  }

  /**
   * Reads up to the end of a statement, or of the text.
   *
   * @param base the index in {@code text} of the offset 0 of the line table
   * @return the index after the last character that was read
   */
  public int scan(CharSequence text, int from, int to, int base) {
    separator = null;
    int at = from;
    while (at < to) {
      char c = text.charAt(at);
      if (isWithin(c)) {
        at++;
        continue;
      }
      offset = at - base;
      if (step(c)) {
        at++;
        if (c == '\n') {
          lines.newLine(at - base);
        }
        if (separator != null) {
          restart();
          break;
        }
      }
    }
    return at;
  }

  private void restart() {
    state = State.CODE;
    blank = true;
    flavorMayFollow = false;
    inside = Brackets.Kind.VALUES;
    inClassHead = false;
    inPrototypes = false;
    brackets.clear();
  }

  /**
   * Processes a character that only continues what most characters are in, and does so in few
   * steps, which counts while a process is young. False if it may be another one: nothing has
   * happened then.
   */
  private boolean isWithin(char c) {
    if (state == State.WORD) {
      if (!Keywords.isInWord(c)) {
        return false;
      }
      if (collected.length() < LONGEST_WORD) {
        collected.append(c);
      }
      return true;
    }
    return c == ' ' && state == State.CODE;
  }

  /**
   * Processes a character; false if it only ended the token before it, and must be processed again.
   */
  private boolean step(char c) {
    switch (state) {
      case CODE -> code(c);
      case WORD -> {
        return word(c);
      }
      case NUMBER -> {
        if (!Keywords.isInWord(c)) {
          state = State.CODE;
          return false;
        }
      }
      case DERIVED -> {
        state = State.CODE;
        return c == '\'';
      }
      case SLASH -> {
        return slash(c);
      }
      case LINE_COMMENT -> lineComment(c);
      case BLOCK_COMMENT -> blockComment(c);
      case QUOTED -> {
        if (c == quote) {
          state = State.CODE;
        } else if (c == '\\') {
          blob.start();
          state = State.ESCAPE;
        }
      }
      case ESCAPE -> {
        EscapeScanner.Answer answer = blob.accept(c, quote);
        if (answer != EscapeScanner.Answer.MORE) {
          state = State.QUOTED;
        }
        return answer != EscapeScanner.Answer.REFUSED;
      }
      case BINARY_HEADER -> {
        return binaryHeader(c);
      }
      case BINARY -> binaryData();
    }
    return true;
  }

  private void code(char c) {
    if (c <= ' ') {
      return;
    }
    if (Keywords.isInWord(c)) {
      blank = false;
      flavorMayFollow = false;
      inside = Brackets.Kind.VALUES;
      state = '0' <= c && c <= '9' ? State.NUMBER : State.WORD;
      collected.setLength(0);
      collected.append(c);
      return;
    }
    if (c == '/') {
      state = State.SLASH;
      return;
    }
    blank = false;
    boolean flavor = flavorMayFollow && ";|,&".indexOf(c) >= 0;
    Brackets.Kind parenthesis = inside;
    flavorMayFollow = false;
    if (!flavor) {
      inside = Brackets.Kind.VALUES;
    }
    switch (c) {
      case '"', '\'' -> {
        quote = c;
        state = State.QUOTED;
      }
      case '(' -> brackets.open(c, parenthesis);
      case '[' -> brackets.open(c, Brackets.Kind.VALUES);
      case '{' -> {
        brackets.open();
        inClassHead = false;
        inPrototypes = false;
      }
      case ')', ']', '}' -> brackets.close(c);
      case ':' -> inPrototypes |= inClassHead && brackets.isEmpty();
      case '|', '&' -> inPrototypes &= !brackets.isEmpty();
      case ';' -> {
        if (!flavor) {
          brackets.separate();
          if (brackets.isEmpty()) {
            separator = Flavor.SEMICOLON;
          }
        }
      }
      case ',' -> {
        if (!flavor && !inPrototypes && brackets.isEmpty()) {
          separator = Flavor.COMMA;
        }
      }
      default -> {}
    }
  }

  /** A word is over. */
  private boolean word(char c) {
    String word = collected.toString();
    state = State.CODE;
    switch (word) {
      case "BIN" -> {
        binary = new BinaryScanner();
        state = State.BINARY_HEADER;
      }
      case "class", "package" -> inClassHead |= brackets.isEmpty();
      case "for" -> inside = Brackets.Kind.CLAUSES;
      case "if", "while", "switch" -> inside = Brackets.Kind.STATEMENTS;
      default -> {}
    }
    flavorMayFollow = Keywords.flavored(word);
    // A quote directly behind a name does not open a quoted name.
    if (c == '\'' && !Keywords.keyword(word)) {
      state = State.DERIVED;
      return true;
    }
    return false;
  }

  private boolean slash(char c) {
    if (c == '/') {
      state = State.LINE_COMMENT;
      wholeLine = lines.atLineStart(offset - 1);
      collected.setLength(0);
      collected.append("//");
      return true;
    }
    if (c == '*') {
      state = State.BLOCK_COMMENT;
      commentDepth = 1;
      previous = 0;
      return true;
    }
    state = State.CODE;
    blank = false;
    flavorMayFollow = false;
    return false;
  }

  private void lineComment(char c) {
    if (c == '\n') {
      if (wholeLine && collected.length() < LONGEST_SYNCLINE) {
        lines.comment(collected.toString());
      }
      state = State.CODE;
    } else if (wholeLine && collected.length() < LONGEST_SYNCLINE) {
      collected.append(c);
    }
  }

  private void blockComment(char c) {
    if (previous == '*' && c == '/') {
      previous = 0;
      if (--commentDepth == 0) {
        state = State.CODE;
      }
    } else if (previous == '/' && c == '*') {
      previous = 0;
      commentDepth++;
    } else {
      previous = c;
    }
  }

  private boolean binaryHeader(char c) {
    switch (binary.accept(c)) {
      case MORE -> {}
      case COMPLETE -> {
        state = State.BINARY;
        binaryRemaining = binary.size();
        endBinary();
      }
      case NONE -> {
        state = State.CODE;
        return false;
      }
      case NONE_IN_NUMBER -> {
        state = State.NUMBER;
        return false;
      }
    }
    return true;
  }

  private void binaryData() {
    binaryRemaining--;
    endBinary();
  }

  /** At top level, binary data is the end of its statement. */
  private void endBinary() {
    if (binaryRemaining == 0) {
      state = State.CODE;
      separator = brackets.isEmpty() ? Flavor.SEMICOLON : null;
    }
  }
}
