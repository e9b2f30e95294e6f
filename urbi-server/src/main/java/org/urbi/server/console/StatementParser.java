package org.urbi.server.console;

import java.util.List;
import java.util.function.BooleanSupplier;
import org.jline.reader.CompletingParsedLine;
import org.jline.reader.EOFError;
import org.jline.reader.ParsedLine;
import org.jline.reader.Parser;
import org.urbi.lang.input.StatementReader;
import org.urbi.lang.text.StatementSplitter;
import org.urbi.server.source.SourceText;

/**
 * A JLine parser for statements: lines are edited together until the last statement in them is
 * whole. It does not interpret quotes and backslashes, because urbiscript does. Its only word is
 * what is completed: the name before the cursor, or the string in which the cursor is.
 */
final class StatementParser implements Parser {
  /** What a statement wants in which nothing else is open. */
  private static final String SEPARATOR = ";";

  private final BooleanSupplier within;
  private final BooleanSupplier goesOn;

  /**
   * @param within whether the lines belong to a statement that has begun before them, so that each
   *     is passed on as it is
   * @param goesOn whether more has come than the lines: what is pasted is one text
   */
  StatementParser(BooleanSupplier within, BooleanSupplier goesOn) {
    this.within = within;
    this.goesOn = goesOn;
  }

  /**
   * What is to follow the lines that the editor has given, so that their last statement is over.
   */
  static String ending(ParsedLine parsed) {
    return parsed instanceof Typed typed ? typed.ending() : "";
  }

  @Override
  public ParsedLine parse(String line, int cursor, ParseContext context) {
    boolean accepts =
        context == ParseContext.ACCEPT_LINE || context == ParseContext.SECONDARY_PROMPT;
    if (accepts && !within.getAsBoolean()) {
      // A comment that the line ends is not what is open at its end.
      StatementSplitter read = StatementSplitter.over(SourceText.bytes(line + '\n'));
      if (read.pending()) {
        String open = read.open();
        if (open.isEmpty() && isHopeless(line) && !goesOn.getAsBoolean()) {
          // Nobody is asked for the end of what the end would not make right.
          return new Typed(line, cursor, SEPARATOR);
        }
        throw new EOFError(-1, -1, "unfinished", open.isEmpty() ? SEPARATOR : open);
      }
    }
    return new Typed(line, cursor, "");
  }

  private static boolean isHopeless(String line) {
    var reader = new StatementReader(null);
    reader.feed(SourceText.bytes(line + '\n'));
    while (reader.next() != null) {
      // Those that are whole are told of by whom they are sent to.
    }
    return reader.hopeless();
  }

  /**
   * The line, and its word before the cursor.
   *
   * @param ending what is to follow the line
   */
  private record Typed(String line, int cursor, String ending) implements CompletingParsedLine {
    @Override
    public String word() {
      String before = line.substring(0, cursor);
      String file = FileNames.typed(before);
      if (file != null) {
        return file;
      }
      int start = cursor;
      while (start > 0 && Character.isJavaIdentifierPart(before.charAt(start - 1))) {
        start--;
      }
      return before.substring(start);
    }

    @Override
    public CharSequence escape(CharSequence candidate, boolean complete) {
      return candidate;
    }

    @Override
    public int rawWordCursor() {
      return word().length();
    }

    @Override
    public int rawWordLength() {
      return word().length();
    }

    @Override
    public int wordCursor() {
      return word().length();
    }

    @Override
    public int wordIndex() {
      return 0;
    }

    @Override
    public List<String> words() {
      return List.of(word());
    }
  }
}
