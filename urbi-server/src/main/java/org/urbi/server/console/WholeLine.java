package org.urbi.server.console;

import java.util.List;
import org.jline.reader.CompletingParsedLine;
import org.jline.reader.ParsedLine;
import org.jline.reader.Parser;

/** Leaves a line as it is: quotes and backslashes are the language's business. */
final class WholeLine implements Parser {
  @Override
  public ParsedLine parse(String line, int cursor, ParseContext context) {
    return new CompletingParsedLine() {
      @Override
      public CharSequence escape(CharSequence candidate, boolean complete) {
        return candidate;
      }

      @Override
      public int rawWordCursor() {
        return cursor;
      }

      @Override
      public int rawWordLength() {
        return line.length();
      }

      @Override
      public String word() {
        return line;
      }

      @Override
      public int wordCursor() {
        return cursor;
      }

      @Override
      public int wordIndex() {
        return 0;
      }

      @Override
      public List<String> words() {
        return List.of(line);
      }

      @Override
      public String line() {
        return line;
      }

      @Override
      public int cursor() {
        return cursor;
      }
    };
  }
}
