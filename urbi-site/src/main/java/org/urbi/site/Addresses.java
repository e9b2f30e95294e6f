package org.urbi.site;

import java.nio.file.Path;

/**
 * Where things of the project are in its site: what is in {@code docs} is at the top, {@code
 * README.md} is the index of its folder.
 */
final class Addresses {
  private static final String MARKDOWN = ".md";
  private static final Path DOCUMENTATION = Path.of("docs");

  private Addresses() {}

  static boolean isPage(Path source) {
    return source.toString().endsWith(MARKDOWN);
  }

  /** The address of a page of Markdown, relative to the site. */
  static String ofPage(Path source) {
    Path place = source.startsWith(DOCUMENTATION) ? DOCUMENTATION.relativize(source) : source;
    String name = place.getFileName().toString().replace(MARKDOWN, "");
    return address(place.resolveSibling(name.equals("README") ? "index.html" : name + ".html"));
  }

  /** The address of a file that is copied as it is. */
  static String ofCopy(Path source) {
    return address(source.startsWith(DOCUMENTATION) ? DOCUMENTATION.relativize(source) : source);
  }

  /** The address of the page that shows a file or a folder. */
  static String ofSource(Path source) {
    return address(Path.of("files")) + "/" + address(source) + ".html";
  }

  /** How a page refers to another address of the site. */
  static String relative(String from, String to) {
    Path folder = Path.of("/" + from).resolveSibling("");
    return address(folder.relativize(Path.of("/" + to)));
  }

  /** What a page at an address means by a link to another one. */
  static String resolve(String from, String link) {
    return address(Path.of("/").relativize(Path.of("/" + from).resolveSibling(link).normalize()));
  }

  private static String address(Path path) {
    return path.toString().replace('\\', '/');
  }
}
