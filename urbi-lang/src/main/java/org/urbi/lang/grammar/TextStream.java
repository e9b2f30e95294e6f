package org.urbi.lang.grammar;

import org.antlr.v4.runtime.CharStream;
import org.antlr.v4.runtime.misc.Interval;

/** A part of a text, read in place: indices are offsets in the whole text. */
public final class TextStream implements CharStream {
  private final String text;
  private final int begin;
  private final int end;
  private int index;

  public TextStream(String text, int begin, int end) {
    this.text = text;
    this.begin = begin;
    this.end = end;
    this.index = begin;
  }

  /** The whole text, of which this stream reads a part. */
  String text() {
    return text;
  }

  /** Where the part that is read ends. */
  int end() {
    return end;
  }

  @Override
  public void consume() {
    index++;
  }

  @Override
  public int LA(int i) {
    int at = i > 0 ? index + i - 1 : index + i;
    return begin <= at && at < end ? text.charAt(at) : EOF;
  }

  @Override
  public int mark() {
    return -1;
  }

  @Override
  public void release(int marker) {
    // The whole text is at hand: there is nothing to release.
  }

  @Override
  public int index() {
    return index;
  }

  @Override
  public void seek(int index) {
    this.index = index;
  }

  @Override
  public int size() {
    return end;
  }

  @Override
  public String getSourceName() {
    return "";
  }

  @Override
  public String getText(Interval interval) {
    int stop = Math.min(interval.b + 1, end);
    return interval.a >= stop ? "" : text.substring(interval.a, stop);
  }
}
