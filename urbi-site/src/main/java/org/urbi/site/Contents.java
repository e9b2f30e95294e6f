package org.urbi.site;

import java.util.ArrayList;
import java.util.List;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Heading;
import org.commonmark.node.Link;

/** What is beside each page: the headings and links of the page of contents. */
final class Contents extends AbstractVisitor {
  private record Entry(String title, String destination) {}

  private record Group(String title, List<Entry> entries) {}

  private final Page page;
  private final List<Group> groups = new ArrayList<>();

  private Contents(Page page) {
    this.page = page;
  }

  /** Those of a page whose links are those of the site already. */
  static Contents of(Page page) {
    Contents contents = new Contents(page);
    page.document().accept(contents);
    return contents;
  }

  @Override
  public void visit(Heading heading) {
    if (heading.getLevel() > 1) {
      groups.add(new Group(Sections.text(heading), new ArrayList<>()));
    }
  }

  @Override
  public void visit(Link link) {
    if (!groups.isEmpty()) {
      groups.getLast().entries().add(new Entry(Sections.text(link), link.getDestination()));
    }
  }

  /** As HTML, for the page at an address. */
  String html(String address) {
    StringBuilder html = new StringBuilder();
    for (Group group : groups) {
      html.append("<h2>").append(Listings.escape(group.title())).append("</h2>\n<ul>\n");
      for (Entry entry : group.entries()) {
        String target = Addresses.resolve(page.address(), entry.destination());
        html.append("<li><a href=\"").append(Listings.escape(Addresses.relative(address, target)));
        html.append(target.equals(address) ? "\" aria-current=\"page\">" : "\">");
        html.append(Listings.escape(entry.title())).append("</a></li>\n");
      }
      html.append("</ul>\n");
    }
    return html.toString();
  }
}
