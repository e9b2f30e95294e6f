package org.urbi.lang.input;

import java.util.List;
import java.util.function.IntSupplier;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.parse.ParseResult;
import org.urbi.lang.parse.SyntaxError;
import org.urbi.lang.parse.UrbiParser;
import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.source.Source;
import org.urbi.lang.source.Span;
import org.urbi.lang.text.LineTable;
import org.urbi.lang.text.StatementSplitter;

/**
 * Reads statements from a stream of characters that comes in pieces of any size, as in an
 * interactive session (manual, "Statement Separators").
 *
 * <p>A statement is complete with its {@code ;} or {@code ,}. A syntax error costs the statement in
 * which it is, up to its separator, and no other. The time that it takes is linear in what is fed,
 * however it is cut into pieces. Not thread-safe.
 */
public final class StatementReader {
  private final LineTable lines;
  private StatementSplitter splitter;
  private final IntSupplier maximumSize;
  private final Runnable checkpoint;
  private final StringBuilder buffer = new StringBuilder();
  private int start;
  private int position;
  private boolean discarding;
  private boolean ended;

  /** A reader without limit to the size of a statement. */
  public StatementReader(@Nullable String file) {
    this(file, () -> Integer.MAX_VALUE, () -> {});
  }

  /**
   * A reader with a limit to the size of a statement.
   *
   * @param file the name that locations show, or null
   * @param maximumSize gives the length, in characters, beyond which a statement is refused
   * @param checkpoint called again and again by {@link #next}, which it ends by an exception
   */
  public StatementReader(@Nullable String file, IntSupplier maximumSize, Runnable checkpoint) {
    this.lines = new LineTable(file, 1);
    this.splitter = new StatementSplitter(lines);
    this.maximumSize = maximumSize;
    this.checkpoint = checkpoint;
  }

  /** Adds input: each {@code char} is a byte, from 0 to 255. */
  public void feed(String chunk) {
    if (ended) {
      throw new IllegalStateException("input after its end");
    }
    // Moving what is left each time would be quadratic when many statements wait.
    if (start > buffer.length() / 2) {
      buffer.delete(0, start);
      position -= start;
      start = 0;
    }
    buffer.append(chunk);
  }

  /** Tells that no more input comes. */
  public void end() {
    ended = true;
  }

  /**
   * The next statement or its errors; null when more input is needed. What it throws is a fault of
   * the reader, and has cost the statement in which it is.
   */
  public @Nullable Item next() {
    while (position < buffer.length()) {
      position = scan();
      boolean complete = splitter.separator() != null;
      if (discarding) {
        discarding = !complete;
        drop();
      } else if (position - start > maximumSize.getAsInt()) {
        discarding = !complete;
        return tooLong();
      } else if (complete) {
        return item();
      }
    }
    return null;
  }

  private int scan() {
    try {
      return splitter.scan(buffer, position, buffer.length(), start);
    } catch (RuntimeException | Error failure) {
      // A fault of the splitter must not meet the same text again.
      position = buffer.length();
      drop();
      splitter = new StatementSplitter(lines);
      throw failure;
    }
  }

  /** Whether the input stops in the middle of a statement or of a comment. */
  public boolean pending() {
    return discarding || splitter.pending();
  }

  /**
   * Tells that the input ended within a statement, which is dropped; null when it did not. To call
   * after the last {@link #next}. If something is wrong in it that no more input could mend, that
   * is told, and not the end.
   */
  public @Nullable Item unfinished() {
    if (discarding || start == position || !splitter.pending()) {
      return null;
    }
    String text = buffer.substring(start);
    Source source = lines.cut(text);
    start = position;
    int end = endOfCode(text);
    SyntaxError mistake = mistakeBefore(source, end);
    return invalid(
        mistake == null
            ? SyntaxError.of(new Span(source, end, end), SyntaxProblem.UNEXPECTED_END)
            : mistake);
  }

  /**
   * Whether the input stops in a statement that cannot be finished, because of a mistake in it. As
   * {@link #unfinished}, to call after the last {@link #next}; drops the statement, too.
   */
  public boolean hopeless() {
    return unfinished() instanceof Item.Invalid invalid
        && invalid.errors().stream()
            .noneMatch(error -> error.problem() == SyntaxProblem.UNEXPECTED_END);
  }

  /** What is wrong in a statement before it breaks off; null when nothing is. */
  private @Nullable SyntaxError mistakeBefore(Source source, int end) {
    return UrbiParser.parseStatement(source, 0, end, checkpoint).errors().stream()
        .filter(error -> error.span().end() < end)
        .findFirst()
        .orElse(null);
  }

  /** Where a text ends, but for white space and for comments that are whole lines. */
  private static int endOfCode(String text) {
    int end = text.length();
    while (true) {
      while (end > 0 && text.charAt(end - 1) <= ' ') {
        end--;
      }
      int line = text.lastIndexOf('\n', end - 1) + 1;
      int begin = line;
      while (begin < end && text.charAt(begin) <= ' ') {
        begin++;
      }
      if (line == 0 || !text.startsWith("//", begin)) {
        return end;
      }
      end = line;
    }
  }

  private static Item result(ParseResult parsed, Ast.@Nullable Flavor separator) {
    Ast tree = parsed.tree();
    return tree != null && parsed.valid()
        ? new Item.Statement(tree, separator, parsed.warnings())
        : new Item.Invalid(parsed.errors(), parsed.warnings());
  }

  private Item item() {
    String text = buffer.substring(start, position);
    Source source = lines.cut(text);
    start = position;
    ParseResult parsed = UrbiParser.parseStatement(source, 0, text.length(), checkpoint);
    return result(parsed, parsed.separator());
  }

  private Item tooLong() {
    String text = buffer.substring(start, position);
    Source source = lines.cut(text);
    start = position;
    Span whole = new Span(source, 0, text.length());
    return invalid(SyntaxError.of(whole, SyntaxProblem.STATEMENT_TOO_LONG, maximumSize.getAsInt()));
  }

  private static Item invalid(SyntaxError error) {
    return new Item.Invalid(List.of(error), List.of());
  }

  private void drop() {
    lines.skip(position - start);
    start = position;
  }
}
