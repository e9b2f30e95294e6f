package org.urbi.kernel.lobby;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.lang.advice.Advice;
import org.urbi.lang.advice.Note;
import org.urbi.lang.source.Location;
import org.urbi.lang.source.Span;

/**
 * What people at a terminal see below an error: the lines of the source with the places marked, and
 * a hint.
 */
final class Explanation {
  /** How much of a line is shown before its place, and in all. */
  private static final int BEFORE = 60;

  private static final int WIDTH = 100;
  private static final String CUT = "...";

  private final ErrorStyle style;
  private final StringBuilder text = new StringBuilder();
  private final List<Place> places = new ArrayList<>();
  private int margin = 1;

  private Explanation(ErrorStyle style) {
    this.style = style;
  }

  /** The explanation, whole lines; the place is null when it is not known. */
  static String of(ErrorStyle style, @Nullable Span place, Advice advice) {
    var made = new Explanation(style);
    if (place != null) {
      made.places.add(Place.of(place, "", true));
    }
    for (Note note : advice.notes()) {
      made.places.add(Place.of(note.span(), Utf8Text.toUrbi(note.text()), false));
    }
    made.places.sort(Comparator.comparingInt(one -> one.begin));
    for (Place one : made.places) {
      made.margin = Math.max(made.margin, String.valueOf(one.at.line()).length());
    }
    made.showPlaces();
    if (advice.hint() != null) {
      made.text
          .append(" ".repeat(made.margin + 3))
          .append(style.hint(Utf8Text.toUrbi("hint: " + advice.hint())))
          .append('\n');
    }
    return made.text.toString();
  }

  private void showPlaces() {
    int shown = -1;
    for (Place place : places) {
      if (place.lineBegin != shown) {
        line(String.valueOf(place.at.line()), place.line());
        shown = place.lineBegin;
      }
      String mark = (place.main ? "^" : "-").repeat(place.width()) + place.label();
      line("", " ".repeat(place.column()) + (place.main ? style.mark(mark) : style.note(mark)));
    }
  }

  private void line(String number, String content) {
    text.append("  ")
        .append(" ".repeat(margin - number.length()))
        .append(number)
        .append(" | ")
        .append(content)
        .append('\n');
  }

  /**
   * A place in a line of the source.
   *
   * @param begin offset of the place in the source
   * @param from what is left out of the line before it is shown
   * @param indent what stands before the text in its line, of which nobody knows the content
   * @param line the part of the line that is shown, a byte in each character
   */
  private record Place(
      Location at,
      int begin,
      int end,
      int lineBegin,
      int from,
      int indent,
      String line,
      String label,
      boolean main) {
    static Place of(Span span, String label, boolean main) {
      String text = span.source().text();
      Location at = span.location();
      int begin = Math.min(span.begin(), text.length());
      int lineBegin = text.lastIndexOf('\n', begin - 1) + 1;
      int lineEnd = text.indexOf('\n', begin);
      if (lineEnd < 0) {
        lineEnd = text.length();
      }
      int indent = lineBegin == 0 ? Math.max(0, at.column() - 1 - begin) : 0;
      int from = begin - lineBegin > BEFORE ? begin - BEFORE : lineBegin;
      int to = Math.min(lineEnd, from + WIDTH);
      String shown =
          (from > lineBegin ? CUT : " ".repeat(Math.min(indent, BEFORE)))
              + clean(text.substring(from, to))
              + (to < lineEnd ? CUT : "");
      return new Place(
          at, begin, Math.min(span.end(), to), lineBegin, from, indent, shown, label(label), main);
    }

    private static String label(String label) {
      return label.isEmpty() ? "" : " " + label;
    }

    /** What would move the marks, or the terminal, is a space. */
    private static String clean(String line) {
      StringBuilder clean = new StringBuilder(line.length());
      for (int i = 0; i < line.length(); i++) {
        char c = line.charAt(i);
        clean.append(c < ' ' || c == 0x7F ? ' ' : c);
      }
      return clean.toString();
    }

    /** Where the place begins in the line that is shown, in characters of a terminal. */
    int column() {
      int lead = from > lineBegin ? CUT.length() : Math.min(indent, BEFORE);
      return lead + characters(lead, lead + begin - from);
    }

    int width() {
      int lead = from > lineBegin ? CUT.length() : Math.min(indent, BEFORE);
      return Math.max(1, characters(lead + begin - from, lead + end - from));
    }

    /** How many characters bytes are: those that continue one in UTF-8 do not count. */
    private int characters(int first, int last) {
      int count = 0;
      for (int i = first; i < Math.min(last, line.length()); i++) {
        if ((line.charAt(i) & 0xC0) != 0x80) {
          count++;
        }
      }
      return count;
    }
  }
}
