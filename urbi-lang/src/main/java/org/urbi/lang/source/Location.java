package org.urbi.lang.source;

import org.jspecify.annotations.Nullable;

/**
 * A location in a file, as shown to users (manual, "Location" and "Position"). Lines and columns
 * count from 1; the end column is exclusive.
 *
 * @param file null when the text was typed
 */
public record Location(@Nullable String file, int line, int column, int endLine, int endColumn) {
  /** {@code file:1.5-7}, {@code 1.5-2.3}, or {@code 1.5} for one character. */
  @Override
  public String toString() {
    var text = new StringBuilder();
    if (file != null) {
      text.append(file).append(':');
    }
    text.append(line).append('.').append(column);
    int last = Math.max(endColumn - 1, 1);
    if (endLine > line) {
      text.append('-').append(endLine).append('.').append(last);
    } else if (last > column) {
      text.append('-').append(last);
    }
    return text.toString();
  }
}
