package org.urbi.lang.input;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.parse.SyntaxError;
import org.urbi.lang.parse.UrbiParser;
import org.urbi.lang.source.Source;

/**
 * Turns text that arrives piece by piece into statements, each as soon as its separator is there.
 * Lines and columns go on from one statement to the next; synclines change them (manual,
 * "Synclines").
 */
public final class StatementReader {
  /** What was read. */
  public sealed interface Item {
    /**
     * A statement.
     *
     * @param separator null when the input ended without one
     */
    record Statement(Ast ast, Ast.Flavor separator) implements Item {}

    /** A statement that is none. */
    record Errors(List<SyntaxError> errors) implements Item {}
  }

  private record Place(String file, int number) {}

  private static final Pattern SYNCLINE =
      Pattern.compile("//#(line|push|pop)(?:\\s+(\\d{1,9}))?(?:\\s+\"(.*)\")?\\s*");

  /** What was read and handed out is dropped when there is that much of it. */
  private static final int COMPACT = 1 << 16;

  private final StringBuilder text = new StringBuilder();
  private Scanner scanner = new Scanner();
  private final Deque<Place> pushed = new ArrayDeque<>();
  private final List<Source.Line> lines = new ArrayList<>();

  /** Where the statement begins, or -1 before its first character. */
  private int begin = -1;

  private int at;
  private int firstColumn;
  private boolean ended;
  private String file;
  private int number = 1;
  private int column = 1;
  private int lineBegin;
  private boolean lineBeginsInCode = true;

  /** Adds text. */
  public void feed(String chunk) {
    text.append(chunk);
  }

  /** Tells that there will be no more text. */
  public void end() {
    ended = true;
  }

  /** Forgets the statement that has begun, and all the text behind it. */
  public void reset() {
    text.setLength(0);
    at = 0;
    begin = -1;
    lineBegin = 0;
    lineBeginsInCode = true;
    scanner = new Scanner();
  }

  /** Whether there is a beginning of a statement, or text still to be read. */
  public boolean pending() {
    return !scanner.isBlank() || !scanner.inCode() || at < text.length();
  }

  /** The next statement, or null when more text is needed. */
  public Item next() {
    while (at < text.length()) {
      if (step(text.charAt(at))) {
        Item item = parse(true);
        begin = -1;
        if (item != null) {
          compact();
          return item;
        }
      }
    }
    compact();
    return null;
  }

  /** What is left after the last separator of a text that ended, or null. */
  public Item rest() {
    if (!ended || begin < 0) {
      return null;
    }
    Item item = parse(false);
    begin = -1;
    return item;
  }

  private boolean step(char c) {
    if (begin < 0 && !(c == ' ' || c >= '\t' && c <= '\r')) {
      begin = at;
      firstColumn = column;
      lines.clear();
      lines.add(new Source.Line(0, file, number));
    }
    boolean end = scanner.take(c);
    at++;
    column++;
    if (c == '\n') {
      number++;
      column = 1;
      syncline();
      lineBegin = at;
      lineBeginsInCode = scanner.inCode();
      if (begin >= 0) {
        if (scanner.isBlank() && lineBeginsInCode) {
          // Only comments so far: the statement is still to begin.
          begin = -1;
        } else {
          lines.add(new Source.Line(at - begin, file, number));
        }
      }
    }
    return end;
  }

  /** Follows the line that just ended, if it is a syncline. */
  private void syncline() {
    if (!lineBeginsInCode
        || at - lineBegin < 6
        || text.charAt(lineBegin) != '/'
        || text.charAt(lineBegin + 2) != '#') {
      return;
    }
    Matcher matcher = SYNCLINE.matcher(text.substring(lineBegin, at));
    if (!matcher.matches()) {
      return;
    }
    if (matcher.group(1).equals("pop")) {
      if (!pushed.isEmpty()) {
        Place place = pushed.pop();
        file = place.file();
        number = place.number();
      }
    } else if (matcher.group(2) != null) {
      if (matcher.group(1).equals("push")) {
        pushed.push(new Place(file, number));
      }
      number = Integer.parseInt(matcher.group(2));
      file = matcher.group(3) == null ? file : matcher.group(3);
    }
  }

  private Item parse(boolean terminated) {
    var source =
        new Source(text.substring(begin, at), firstColumn, lines.toArray(Source.Line[]::new));
    UrbiParser.Parsed parsed = UrbiParser.parse(source);
    if (!parsed.errors().isEmpty()) {
      return new Item.Errors(parsed.errors());
    }
    Ast.Sequence program = parsed.program();
    if (program.statements().isEmpty()) {
      return null;
    }
    Ast ast = program.statements().size() == 1 ? program.statements().getFirst() : program;
    return new Item.Statement(ast, terminated ? program.separators().getLast() : null);
  }

  private void compact() {
    int keep = Math.min(lineBegin, begin < 0 ? at : begin);
    if (keep >= COMPACT || keep == text.length()) {
      text.delete(0, keep);
      at -= keep;
      lineBegin -= keep;
      begin = begin < 0 ? -1 : begin - keep;
    }
  }
}
