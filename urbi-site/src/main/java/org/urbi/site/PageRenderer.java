package org.urbi.site;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.node.FencedCodeBlock;
import org.commonmark.node.Heading;
import org.commonmark.node.HtmlBlock;
import org.commonmark.node.HtmlInline;
import org.commonmark.node.IndentedCodeBlock;
import org.commonmark.node.Node;
import org.commonmark.renderer.NodeRenderer;
import org.commonmark.renderer.html.HtmlNodeRendererContext;
import org.commonmark.renderer.html.HtmlRenderer;
import org.commonmark.renderer.html.HtmlWriter;

/** What commonmark makes of a page, but for its headings, its listings and the HTML within it. */
final class PageRenderer implements NodeRenderer {
  private static final Pattern COMMENT = Pattern.compile("(?s)\\s*<!--.*?-->\\s*");
  private static final Pattern RAISED = Pattern.compile("</?su[bp]>");

  private final HtmlNodeRendererContext context;
  private final HtmlWriter html;
  private final Map<Heading, String> ids;

  private PageRenderer(HtmlNodeRendererContext context, Map<Heading, String> ids) {
    this.context = context;
    this.html = context.getWriter();
    this.ids = ids;
  }

  static String html(Page page) {
    return HtmlRenderer.builder()
        .extensions(List.of(TablesExtension.create()))
        .nodeRendererFactory(context -> new PageRenderer(context, page.sections().ids()))
        .build()
        .render(page.document());
  }

  @Override
  public Set<Class<? extends Node>> getNodeTypes() {
    return Set.of(
        Heading.class,
        FencedCodeBlock.class,
        IndentedCodeBlock.class,
        HtmlBlock.class,
        HtmlInline.class);
  }

  @Override
  public void render(Node node) {
    switch (node) {
      case Heading heading -> heading(heading);
      case FencedCodeBlock block -> listing(block.getInfo().strip(), block.getLiteral());
      case IndentedCodeBlock block -> listing("", block.getLiteral());
      case HtmlBlock block -> markup(block.getLiteral());
      case HtmlInline inline -> markup(inline.getLiteral());
      default -> throw new IllegalArgumentException("not asked for: " + node);
    }
  }

  private void heading(Heading heading) {
    String id = ids.get(heading);
    String name = "h" + heading.getLevel();
    html.line();
    html.tag(name, Map.of("id", id));
    for (Node child = heading.getFirstChild(); child != null; child = child.getNext()) {
      context.render(child);
    }
    html.raw(" <a class=\"anchor\" href=\"#" + id + "\" aria-label=\"Link to this place\">#</a>");
    html.tag("/" + name);
    html.line();
  }

  private void listing(String language, String text) {
    html.line();
    html.raw("<pre" + (language.equals("mermaid") ? " class=\"diagram\"" : "") + "><code>");
    html.raw(language.equals("urbiscript") ? Listings.urbiscript(text) : Listings.escape(text));
    html.raw("</code></pre>");
    html.line();
  }

  /** Comments are for tests, small letters are small; whatever else looks like HTML is text. */
  private void markup(String text) {
    if (RAISED.matcher(text).matches()) {
      html.raw(text);
    } else if (!COMMENT.matcher(text).matches()) {
      html.text(text);
    }
  }
}
