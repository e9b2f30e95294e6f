package org.urbi.kernel.library.reference;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * What is written about a type, besides the sentences in its declarations: Markdown with its name
 * as title, what it is for, and a heading {@code ### `name`, `name`} for the slots of which the
 * text below it tells.
 *
 * @param parts the pieces in their order
 */
record TypeText(List<Part> parts) {
  private static final Pattern NAME = Pattern.compile("`([^`]+)`");
  private static final String FENCE = "```";

  /**
   * A piece of text.
   *
   * @param names the slots that it is about; none for text about the type, or about several slots
   * @param markdown the text, without the heading of the slots
   */
  record Part(List<String> names, String markdown) {}

  /** The text about a type; empty when there is none yet. */
  static Optional<TypeText> of(String type) {
    return resource(type + ".md").map(TypeText::parse);
  }

  /** A resource of this package. */
  static Optional<String> resource(String name) {
    try (InputStream in = TypeText.class.getResourceAsStream(name)) {
      return in == null
          ? Optional.empty()
          : Optional.of(new String(in.readAllBytes(), StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static TypeText parse(String text) {
    List<String> lines = text.lines().toList();
    List<Part> parts = new ArrayList<>();
    List<String> names = List.of();
    StringBuilder markdown = new StringBuilder();
    boolean code = false;
    for (String line : lines.subList(1, lines.size())) {
      code ^= line.startsWith(FENCE);
      boolean slots = !code && line.startsWith("### ");
      if (slots || !code && line.startsWith("## ")) {
        parts.add(new Part(names, markdown.toString().strip()));
        names = slots ? names(line) : List.of();
        markdown.setLength(0);
      }
      if (!slots) {
        markdown.append(line).append('\n');
      }
    }
    parts.add(new Part(names, markdown.toString().strip()));
    return new TypeText(parts);
  }

  private static List<String> names(String heading) {
    return NAME.matcher(heading).results().map(found -> found.group(1)).toList();
  }
}
