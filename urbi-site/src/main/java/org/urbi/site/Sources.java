package org.urbi.site;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/**
 * Pages that show what pages of Markdown refer to: files, and folders without a page of their own.
 */
final class Sources {
  private static final long LONGEST = 200_000;

  /** What builds leave behind. */
  private static final Set<String> BUILT = Set.of("bin", "target");

  private Sources() {}

  /**
   * The contents of a file, or those of a folder, in which what is linked is added to the others.
   */
  static String html(Path project, Path source, Set<Path> others) throws IOException {
    Path file = project.resolve(source);
    StringBuilder html = new StringBuilder("<h1>" + Listings.escape(source.toString()) + "</h1>\n");
    if (!Files.isDirectory(file)) {
      String text = Files.readString(file);
      html.append("<pre><code>")
          .append(isProgram(source) ? Listings.urbiscript(text) : Listings.escape(text));
      return html.append("</code></pre>\n").toString();
    }
    html.append("<ul>\n");
    for (Path each : within(file)) {
      Path inside = project.relativize(each);
      html.append("<li>");
      if (isText(each)) {
        String from = Addresses.ofSource(source);
        others.add(inside);
        html.append("<a href=\"").append(Addresses.relative(from, Addresses.ofSource(inside)));
        html.append("\">").append(Listings.escape(file.relativize(each).toString())).append("</a>");
      } else {
        html.append(Listings.escape(file.relativize(each).toString()));
      }
      html.append("</li>\n");
    }
    return html.append("</ul>\n").toString();
  }

  private static boolean isProgram(Path source) {
    return source.toString().endsWith(".u") || source.toString().endsWith(".u-session");
  }

  private static Set<Path> within(Path folder) throws IOException {
    Set<Path> files = new TreeSet<>();
    try (Stream<Path> all = Files.list(folder)) {
      for (Path each : all.toList()) {
        String name = each.getFileName().toString();
        if (name.startsWith(".") || BUILT.contains(name)) {
          continue;
        }
        files.addAll(Files.isDirectory(each) ? within(each) : List.of(each));
      }
    }
    return files;
  }

  private static boolean isText(Path file) throws IOException {
    if (Files.size(file) > LONGEST) {
      return false;
    }
    try {
      return Files.readString(file).indexOf('\0') < 0;
    } catch (CharacterCodingException e) {
      return false;
    }
  }
}
