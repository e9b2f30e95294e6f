package org.urbi.server.console;

import java.util.List;
import java.util.function.BooleanSupplier;
import org.jline.reader.CompletingParsedLine;
import org.jline.reader.EOFError;
import org.jline.reader.ParsedLine;
import org.jline.reader.Parser;
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

  /**
   * @param within whether the lines belong to a statement that has begun before them, so that each
   *     is passed on as it is
   */
  StatementParser(BooleanSupplier within) {
    this.within = within;
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
        throw new EOFError(-1, -1, "unfinished", open.isEmpty() ? SEPARATOR : open);
      }
    }
    return new Typed(line, cursor);
  }

  /** The line, and its word before the cursor. */
  private record Typed(String line, int cursor) implements CompletingParsedLine {
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
