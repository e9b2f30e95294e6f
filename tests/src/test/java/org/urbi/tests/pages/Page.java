package org.urbi.tests.pages;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.urbi.tests.pages.Listing.Kind;

/**
 * A page in Markdown, and its listings: fenced blocks, and indented ones. The line before a listing
 * says what is done with it, {@code <!-- listing: KIND -->} or {@code <!-- listing: KIND: DETAIL
 * -->}. Fenced blocks of {@code urbiscript} need no such marker, and diagrams are no listings.
 *
 * @param file where it is
 * @param text its lines
 * @param listings in their order
 */
record Page(Path file, List<String> text, List<Listing> listings) {
  private static final Pattern MARKER = Pattern.compile("<!-- listing: ([^:]*)(?:: (.*))? -->");
  private static final String FENCE = "```";
  private static final String INDENTATION = "    ";
  private static final String DIAGRAM = "mermaid";

  static Page read(Path file) {
    try {
      return parse(file, Files.readAllLines(file));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static Page parse(Path file, List<String> text) {
    List<Listing> listings = new ArrayList<>();
    for (int i = 0; i < text.size(); i++) {
      String line = text.get(i);
      int begin = i;
      if (line.startsWith(FENCE)) {
        i = endOfFence(file, text, i + 1);
        String language = line.substring(FENCE.length()).strip();
        if (!language.equals(DIAGRAM)) {
          List<String> content = List.copyOf(text.subList(begin + 1, i));
          listings.add(listing(file, text, begin, language, content));
        }
      } else if (line.startsWith(INDENTATION) && (i == 0 || text.get(i - 1).isBlank())) {
        while (i + 1 < text.size() && isIndented(text, i + 1)) {
          i++;
        }
        List<String> content =
            text.subList(begin, i + 1).stream()
                .map(shown -> shown.substring(Math.min(INDENTATION.length(), shown.length())))
                .toList();
        listings.add(listing(file, text, begin, "", content));
      }
    }
    return new Page(file, text, List.copyOf(listings));
  }

  private static int endOfFence(Path file, List<String> text, int from) {
    for (int i = from; i < text.size(); i++) {
      if (text.get(i).equals(FENCE)) {
        return i;
      }
    }
    throw new IllegalArgumentException(file + ":" + from + ": the listing does not end");
  }

  /** Whether a line belongs to an indented block; blank ones do, when such a one follows. */
  private static boolean isIndented(List<String> text, int line) {
    int next = line;
    while (next < text.size() && text.get(next).isBlank()) {
      next++;
    }
    return next < text.size() && text.get(next).startsWith(INDENTATION);
  }

  private static Listing listing(
      Path file, List<String> text, int begin, String language, List<String> content) {
    int before = begin - 1;
    while (0 <= before && text.get(before).isBlank()) {
      before--;
    }
    Matcher marker = MARKER.matcher(before < 0 ? "" : text.get(before));
    String place = file + ":" + (begin + 1) + ": ";
    if (marker.matches()) {
      String detail = marker.group(2) == null ? "" : marker.group(2);
      try {
        return new Listing(begin + 1, Kind.of(marker.group(1), detail), detail, content);
      } catch (IllegalArgumentException e) {
        throw new IllegalArgumentException(place + e.getMessage(), e);
      }
    }
    if (language.equals("urbiscript")) {
      return new Listing(begin + 1, Kind.SESSION, "", content);
    }
    throw new IllegalArgumentException(
        place + "nothing says what this listing is: <!-- listing: KIND --> before it does");
  }

  /** The listings of some kinds. */
  List<Listing> listings(Kind... kinds) {
    return listings.stream().filter(listing -> List.of(kinds).contains(listing.kind())).toList();
  }

  /** Where a listing is, for people. */
  String place(Listing listing) {
    return file.normalize() + ":" + listing.line();
  }
}
