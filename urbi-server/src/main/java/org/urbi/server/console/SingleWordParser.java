package org.urbi.server.console;

import java.util.List;
import org.jline.reader.CompletingParsedLine;
import org.jline.reader.ParsedLine;
import org.jline.reader.Parser;

/**
 * A JLine parser that does not interpret quotes and backslashes, because urbiscript does. Its only
 * word is the name before the cursor, for completion.
 */
final class SingleWordParser implements Parser {
  @Override
  public ParsedLine parse(String line, int cursor, ParseContext context) {
    int start = cursor;
    while (start > 0 && Character.isJavaIdentifierPart(line.charAt(start - 1))) {
      start--;
    }
    String name = line.substring(start, cursor);
    return new CompletingParsedLine() {
      @Override
      public CharSequence escape(CharSequence candidate, boolean complete) {
        return candidate;
      }

      @Override
      public int rawWordCursor() {
        return name.length();
      }

      @Override
      public int rawWordLength() {
        return name.length();
      }

      @Override
      public String word() {
        return name;
      }

      @Override
      public int wordCursor() {
        return name.length();
      }

      @Override
      public int wordIndex() {
        return 0;
      }

      @Override
      public List<String> words() {
        return List.of(name);
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
