package org.urbi.site;

import java.util.Collection;
import java.util.regex.Pattern;

/**
 * What is searched: a script that sets {@code SEARCH_DATA} to the parts of all pages, since pages
 * that are files on a disk may load scripts and nothing else.
 */
final class SearchData {
  private static final Pattern BLANKS = Pattern.compile("\\s+");

  private SearchData() {}

  static String of(Collection<Page> pages) {
    StringBuilder script = new StringBuilder("const SEARCH_DATA = [\n");
    for (Page page : pages) {
      for (Section section : page.sections().list()) {
        String place = section.level() == 1 ? page.address() : page.address() + "#" + section.id();
        script.append('[').append(quote(place)).append(',').append(quote(page.title()));
        script.append(',').append(quote(section.title()));
        script.append(',').append(quote(section.text())).append("],\n");
      }
    }
    return script.append("];\n").toString();
  }

  private static String quote(String text) {
    StringBuilder quoted = new StringBuilder("\"");
    for (char c : BLANKS.matcher(text).replaceAll(" ").toCharArray()) {
      if (c == '"' || c == '\\') {
        quoted.append('\\').append(c);
      } else if (c < ' ' || c == '\u2028' || c == '\u2029') {
        quoted.append(String.format("\\u%04x", (int) c));
      } else {
        quoted.append(c);
      }
    }
    return quoted.append('"').toString();
  }
}
