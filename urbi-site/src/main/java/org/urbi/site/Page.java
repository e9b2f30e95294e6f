package org.urbi.site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.node.Node;
import org.commonmark.parser.IncludeSourceSpans;
import org.commonmark.parser.Parser;

/**
 * A page of Markdown.
 *
 * @param source where it is, relative to the project
 * @param address where it is in the site
 * @param document its contents
 * @param sections its parts
 */
record Page(Path source, String address, Node document, Sections.Division sections) {
  private static final Parser PARSER =
      Parser.builder()
          .extensions(List.of(TablesExtension.create()))
          .includeSourceSpans(IncludeSourceSpans.BLOCKS_AND_INLINES)
          .build();

  static Page read(Path project, Path source) throws IOException {
    Node document = PARSER.parse(Files.readString(project.resolve(source)));
    return new Page(source, Addresses.ofPage(source), document, Sections.of(document));
  }

  String title() {
    return sections.list().isEmpty() ? source.toString() : sections.list().getFirst().title();
  }

  boolean has(String anchor) {
    return sections.ids().containsValue(anchor);
  }
}
