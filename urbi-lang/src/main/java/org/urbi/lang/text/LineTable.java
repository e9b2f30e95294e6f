package org.urbi.lang.text;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.source.Source;

/** The lines of a text as it is read, with synclines applied (manual, "Synclines"). */
public final class LineTable {
  private static final Pattern SYNCLINE =
      Pattern.compile("//#(line|push)[ \\t]+([0-9]{1,9})[ \\t]+\"([^\"]*)\"[ \\t\\r]*");
  private static final Pattern PUSH = Pattern.compile("//#push[ \\t]+([0-9]{1,9})[ \\t\\r]*");
  private static final Pattern POP = Pattern.compile("//#pop[ \\t\\r]*");

  private record Position(@Nullable String file, int number) {}

  private final Deque<Position> saved = new ArrayDeque<>();
  private List<Source.Line> lines = new ArrayList<>();
  private @Nullable String file;
  private int number;
  private int lineStart;
  private int firstColumn = 1;
  private @Nullable Position following;

  /** The table of a text that starts at the beginning of a line. */
  public LineTable(@Nullable String file, int number) {
    this.file = file;
    this.number = number;
    lines.add(new Source.Line(0, file, number));
  }

  /** A line ended: the next one starts at {@code offset} in the current text. */
  void newLine(int offset) {
    if (following == null) {
      number++;
    } else {
      file = following.file();
      number = following.number();
      following = null;
    }
    lineStart = offset;
    lines.add(new Source.Line(offset, file, number));
  }

  /**
   * A comment was read that is a whole line: it may be a syncline, which sets the location of the
   * next line.
   */
  void comment(String comment) {
    if (!comment.startsWith("//#")) {
      return;
    }
    Matcher matcher = SYNCLINE.matcher(comment);
    Matcher push = PUSH.matcher(comment);
    if (matcher.matches()) {
      if (matcher.group(1).equals("push")) {
        saved.push(new Position(file, number));
      }
      following = new Position(matcher.group(3), Integer.parseInt(matcher.group(2)));
    } else if (push.matches()) {
      // A push without a file name changes to no file.
      saved.push(new Position(file, number));
      following = new Position(null, Integer.parseInt(push.group(1)));
    } else if (POP.matcher(comment).matches() && !saved.isEmpty()) {
      Position position = saved.pop();
      following = new Position(position.file(), position.number() + 1);
    }
  }

  /** Whether an offset of the current text starts a line. */
  boolean atLineStart(int offset) {
    return offset == lineStart && (offset > 0 || firstColumn == 1);
  }

  /** The current text is complete: makes it a source, and starts the next text at its end. */
  public Source cut(String text) {
    var source = new Source(text, firstColumn, lines.toArray(Source.Line[]::new));
    skip(text.length());
    return source;
  }

  /** Starts the next text at an offset of the current one. */
  public void skip(int offset) {
    firstColumn = offset - lineStart + (lineStart == 0 ? firstColumn : 1);
    lineStart = 0;
    lines = new ArrayList<>();
    lines.add(new Source.Line(0, file, number));
  }
}
