package org.urbi.site;

import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.urbi.lang.highlight.Kind;
import org.urbi.lang.highlight.Piece;
import org.urbi.lang.highlight.Pieces;

/** Colours urbiscript: each piece as the scanner of the language reads it, answers apart. */
final class Listings {
  /** Answers of a kernel: lines that begin with a time stamp. */
  private static final Pattern ANSWERS =
      Pattern.compile("(?m)(?:^\\[(?:\\d{8,}|)(?::\\w*)?\\].*\\R?)+");

  private Listings() {}

  /** A program or a session, as HTML. */
  static String urbiscript(String text) {
    StringBuilder html = new StringBuilder();
    int at = 0;
    for (Matcher answers = ANSWERS.matcher(text); answers.find(); at = answers.end()) {
      colour(text.substring(at, answers.start()), html);
      span("answer", answers.group(), html);
    }
    colour(text.substring(at), html);
    return html.toString();
  }

  /** What was typed in a session. */
  static String input(String text) {
    return ANSWERS.matcher(text).replaceAll("");
  }

  static String escape(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }

  private static void colour(String text, StringBuilder html) {
    int at = 0;
    List<Piece> pieces = Pieces.of(text);
    for (Piece piece : pieces) {
      html.append(escape(text.substring(at, piece.begin())));
      String shown = text.substring(piece.begin(), piece.end());
      switch (piece.kind()) {
        case NAME, SYMBOL, INVALID, CONTEXTUAL -> html.append(escape(shown));
        default -> span(style(piece.kind()), shown, html);
      }
      at = piece.end();
    }
    html.append(escape(text.substring(at)));
  }

  private static String style(Kind kind) {
    return kind.name().toLowerCase(Locale.ROOT);
  }

  private static void span(String style, String text, StringBuilder html) {
    html.append("<span class=\"")
        .append(style)
        .append("\">")
        .append(escape(text))
        .append("</span>");
  }
}
