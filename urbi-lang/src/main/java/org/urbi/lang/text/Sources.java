package org.urbi.lang.text;

import org.jspecify.annotations.Nullable;
import org.urbi.lang.source.Source;

/** Creates the sources of complete texts. */
public final class Sources {
  private Sources() {}

  /** The source of a complete text, with its synclines applied. */
  public static Source of(String text, @Nullable String file) {
    var lines = new LineTable(file, 1);
    var splitter = new StatementSplitter(lines);
    int at = 0;
    while (at < text.length()) {
      at = splitter.scan(text, at, text.length(), 0);
    }
    return lines.cut(text);
  }
}
