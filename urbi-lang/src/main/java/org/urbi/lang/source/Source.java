package org.urbi.lang.source;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * A text and the one table that turns its offsets into lines and columns.
 *
 * <p>Every {@code char} of the text stands for one byte. Synclines ({@code //#line}, {@code
 * //#push}, {@code //#pop}; manual, "Synclines") change file and line for what follows; so a source
 * consists of {@link Line}s, each with the file name and line number to show.
 */
public final class Source {
  /** A line: the offset of its first character, and the file name and line number to show. */
  public record Line(int offset, @Nullable String file, int number) {}

  private final String text;
  private final int firstColumn;
  private final Line[] lines;
  private final int[] offsets;

  /**
   * @param lines at least one, in the order of their offsets, the first at 0
   * @param firstColumn the column of offset 0, when the text starts in the middle of a line
   */
  public Source(String text, int firstColumn, Line... lines) {
    this.text = text;
    this.firstColumn = firstColumn;
    this.lines = lines.clone();
    this.offsets = Arrays.stream(lines).mapToInt(Line::offset).toArray();
  }

  public String text() {
    return text;
  }

  Location location(int begin, int end) {
    Line first = lines[lineOf(begin)];
    Line last = lines[lineOf(Math.max(begin, end - 1))];
    return new Location(
        first.file(),
        first.number(),
        column(first, begin),
        last.number(),
        column(last, Math.max(begin, end - 1)) + 1);
  }

  private int lineOf(int offset) {
    int found = Arrays.binarySearch(offsets, offset);
    return found >= 0 ? found : Math.max(0, -found - 2);
  }

  private int column(Line line, int offset) {
    return offset - line.offset() + (line.offset() == 0 ? firstColumn : 1);
  }
}
