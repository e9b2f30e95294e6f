package org.urbi.site;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.commonmark.ext.gfm.tables.TableCell;
import org.commonmark.ext.heading.anchor.IdGenerator;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Block;
import org.commonmark.node.Code;
import org.commonmark.node.FencedCodeBlock;
import org.commonmark.node.HardLineBreak;
import org.commonmark.node.Heading;
import org.commonmark.node.IndentedCodeBlock;
import org.commonmark.node.Node;
import org.commonmark.node.SoftLineBreak;
import org.commonmark.node.Text;

/** Divides a page at its headings. */
final class Sections extends AbstractVisitor {
  private final IdGenerator generator = IdGenerator.builder().build();
  private final List<Section> sections = new ArrayList<>();
  private final Map<Heading, String> ids = new HashMap<>();
  private StringBuilder text = new StringBuilder();

  private Sections() {}

  /**
   * @param list in their order
   * @param ids the anchor of each heading
   */
  record Division(List<Section> list, Map<Heading, String> ids) {}

  static Division of(Node document) {
    Sections sections = new Sections();
    document.accept(sections);
    sections.finish();
    return new Division(List.copyOf(sections.sections), Map.copyOf(sections.ids));
  }

  /** The text of a node, without what marks it up. */
  static String text(Node node) {
    Sections reader = new Sections();
    reader.visitChildren(node);
    return reader.text.toString().strip();
  }

  private void finish() {
    if (!sections.isEmpty()) {
      Section last = sections.removeLast();
      sections.add(new Section(last.id(), last.level(), last.title(), text.toString().strip()));
    }
    text = new StringBuilder();
  }

  @Override
  public void visit(Heading heading) {
    finish();
    String title = text(heading);
    String id = generator.generateId(title);
    ids.put(heading, id);
    sections.add(new Section(id, heading.getLevel(), title, ""));
  }

  @Override
  public void visit(Text node) {
    text.append(node.getLiteral());
  }

  @Override
  public void visit(Code node) {
    text.append(node.getLiteral());
  }

  @Override
  public void visit(SoftLineBreak node) {
    text.append(' ');
  }

  @Override
  public void visit(HardLineBreak node) {
    text.append(' ');
  }

  @Override
  public void visit(FencedCodeBlock node) {
    text.append(Listings.input(node.getLiteral()));
  }

  @Override
  public void visit(IndentedCodeBlock node) {
    text.append(node.getLiteral());
  }

  @Override
  protected void visitChildren(Node parent) {
    super.visitChildren(parent);
    if (parent instanceof Block || parent instanceof TableCell) {
      text.append(' ');
    }
  }
}
