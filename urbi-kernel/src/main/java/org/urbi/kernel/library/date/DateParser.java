package org.urbi.kernel.library.date;

import java.time.DateTimeException;
import java.time.LocalDateTime;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** Reads dates (manual, "Date", "Construction"). */
final class DateParser {
  private static final Pattern DATE =
      Pattern.compile(
          "(\\d{4})[-/](\\d{1,2}|[A-Za-z]{3})[-/](\\d{1,2})"
              + "(?: (\\d{1,2})(?:[:.](\\d{1,2})(?:[:.](\\d{1,2})(?:[:.,](\\d{1,6}))?)?)?)?");

  private static final List<String> MONTHS =
      List.of("jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec");

  private DateParser() {}

  /** The date; null when the text is no date. */
  static @Nullable LocalDateTime parse(String text) {
    Matcher matcher = DATE.matcher(text);
    if (!matcher.matches()) {
      return null;
    }
    String fraction = matcher.group(7) == null ? "" : matcher.group(7);
    try {
      return LocalDateTime.of(
          number(matcher.group(1)),
          month(matcher.group(2)),
          number(matcher.group(3)),
          number(matcher.group(4)),
          number(matcher.group(5)),
          number(matcher.group(6)),
          1000 * number(fraction + "0".repeat(6 - fraction.length())));
    } catch (DateTimeException e) {
      return null;
    }
  }

  private static int number(String digits) {
    return digits == null ? 0 : Integer.parseInt(digits);
  }

  private static int month(String text) {
    return Character.isDigit(text.charAt(0))
        ? number(text)
        : MONTHS.indexOf(text.toLowerCase(Locale.ROOT)) + 1;
  }
}
