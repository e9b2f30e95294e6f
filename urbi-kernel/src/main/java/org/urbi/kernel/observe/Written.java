package org.urbi.kernel.observe;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.lang.source.Span;

/** What is shown of a piece of source. */
final class Written {
  private static final int LONGEST_LINE = 200;
  private static final int LONGEST_BEGINNING = 60;

  private Written() {}

  /** Where it is; empty when nobody knows. */
  static String place(@Nullable Span span) {
    return span == null || span.source().text().isEmpty()
        ? ""
        : Utf8Text.toJava(span.location().toString());
  }

  /** The beginning of what was written, as far as it stands in one line. */
  static String beginning(@Nullable Span span) {
    if (span == null) {
      return "";
    }
    String text = span.source().text();
    int line = text.indexOf('\n', span.begin());
    int end =
        Math.min(
            line < 0 ? span.end() : Math.min(line, span.end()), span.begin() + LONGEST_BEGINNING);
    return Utf8Text.toJava(text.substring(span.begin(), Math.max(span.begin(), end))).strip();
  }

  /** A piece of source in one line, or the beginning of it. */
  static String brief(String source) {
    String line = source.strip().replaceAll("\\s+", " ");
    return Utf8Text.toJava(
        line.length() > LONGEST_BEGINNING ? line.substring(0, LONGEST_BEGINNING) + "…" : line);
  }

  /** The line in which it begins, or the beginning of it; empty when nobody knows. */
  static String line(@Nullable Span span) {
    if (span == null) {
      return "";
    }
    String text = span.source().text();
    int begin = text.lastIndexOf('\n', span.begin() - 1) + 1;
    int end = text.indexOf('\n', span.begin());
    end = Math.min(end < 0 ? text.length() : end, begin + LONGEST_LINE);
    return Utf8Text.toJava(text.substring(begin, Math.max(begin, end))).strip();
  }
}
