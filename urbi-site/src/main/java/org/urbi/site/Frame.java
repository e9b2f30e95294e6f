package org.urbi.site;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** What is around each page. */
final class Frame {
  private static final Pattern PLACE = Pattern.compile("\\{\\{(\\w+)}}");
  private static final int LEVELS_TOLD = 3;

  private final String template;
  private final Contents contents;
  private final String version;

  /**
   * @param contents what is beside each page
   * @param version that of the software
   */
  Frame(Contents contents, String version) throws IOException {
    this.template = resource("page.html");
    this.contents = contents;
    this.version = version;
  }

  static String resource(String name) throws IOException {
    try (InputStream stream = Frame.class.getResourceAsStream(name)) {
      if (stream == null) {
        throw new IOException("the jar has no " + name);
      }
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  /** The page at an address, with the parts that it has. */
  String html(String address, String title, String content, List<Section> sections) {
    String root = Addresses.relative(address, "");
    Map<String, String> values =
        Map.of(
            "TITLE", Listings.escape(title),
            "VERSION", Listings.escape(version),
            "ROOT", root.isEmpty() ? "" : root + "/",
            "CONTENTS", contents.html(address),
            "PARTS", parts(sections),
            "CONTENT", content);
    return PLACE
        .matcher(template)
        .replaceAll(place -> Matcher.quoteReplacement(values.getOrDefault(place.group(1), "")));
  }

  private static String parts(List<Section> sections) {
    StringBuilder html = new StringBuilder();
    for (Section section : sections) {
      if (1 < section.level() && section.level() <= LEVELS_TOLD) {
        html.append("<li class=\"level").append(section.level()).append("\"><a href=\"#");
        html.append(section.id()).append("\">").append(Listings.escape(section.title()));
        html.append("</a></li>\n");
      }
    }
    return html.toString();
  }
}
