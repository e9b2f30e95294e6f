package org.urbi.site;

import java.util.List;

/** The documentation has mistakes, so that no site is made of it. */
public final class SiteException extends Exception {
  private final List<String> mistakes;

  SiteException(List<String> mistakes) {
    super(String.join("\n", mistakes));
    this.mistakes = List.copyOf(mistakes);
  }

  /** A line for each mistake, {@code FILE:LINE: what is wrong}. */
  public List<String> mistakes() {
    return mistakes;
  }
}
