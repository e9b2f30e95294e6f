package org.urbi.lang.source;

/** A piece of a source text: offsets from {@code begin}, inclusive, to {@code end}, exclusive. */
public record Span(Source source, int begin, int end) {
  /** The location of the piece, as shown to users. */
  public Location location() {
    return source.location(begin, end);
  }

  /** From the beginning of this piece to the end of the other. */
  public Span to(Span last) {
    return new Span(source, begin, last.end);
  }

  /** The text itself. */
  public String text() {
    return source.text().substring(begin, end);
  }
}
