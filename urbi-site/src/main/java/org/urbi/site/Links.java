package org.urbi.site;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Image;
import org.commonmark.node.Link;
import org.commonmark.node.Node;

/** Turns the links of a page into those of the site, and notes where they lead. */
final class Links extends AbstractVisitor {
  /**
   * A link to a place in a page.
   *
   * @param place where the link is, for people
   */
  record Anchor(String place, Path page, String id) {}

  private static final Pattern ELSEWHERE = Pattern.compile("^[a-z][a-z0-9+.-]*:.*");
  private static final Pattern PICTURE = Pattern.compile(".*\\.(png|jpg|svg)");

  private final Path project;
  private final Page page;
  final TreeSet<Path> pages = new TreeSet<>();
  final TreeSet<Path> copies = new TreeSet<>();
  final TreeSet<Path> files = new TreeSet<>();
  final List<Anchor> anchors = new ArrayList<>();
  final List<String> mistakes = new ArrayList<>();

  private Links(Path project, Page page) {
    this.project = project;
    this.page = page;
  }

  static Links of(Path project, Page page) {
    Links links = new Links(project, page);
    page.document().accept(links);
    return links;
  }

  @Override
  public void visit(Link link) {
    link.setDestination(resolve(link, link.getDestination()));
    visitChildren(link);
  }

  @Override
  public void visit(Image image) {
    image.setDestination(resolve(image, image.getDestination()));
    visitChildren(image);
  }

  private String resolve(Node node, String destination) {
    if (ELSEWHERE.matcher(destination).matches()) {
      return destination;
    }
    int hash = destination.indexOf('#');
    String file = hash < 0 ? destination : destination.substring(0, hash);
    String anchor = hash < 0 ? "" : destination.substring(hash);
    Path target = file.isEmpty() ? page.source() : page.source().resolveSibling(file).normalize();
    if (target.startsWith("..") || !Files.exists(project.resolve(target))) {
      mistakes.add(place(node) + "there is no " + target);
      return destination;
    }
    if (Files.exists(project.resolve(target).resolve("README.md"))) {
      target = target.resolve("README.md");
    }
    if (!anchor.isEmpty()) {
      anchors.add(new Anchor(place(node), target, anchor.substring(1)));
    }
    return file.isEmpty() ? anchor : Addresses.relative(page.address(), address(target)) + anchor;
  }

  private String address(Path target) {
    if (Addresses.isPage(target)) {
      pages.add(target);
      return Addresses.ofPage(target);
    }
    if (PICTURE.matcher(target.toString()).matches()) {
      copies.add(target);
      return Addresses.ofCopy(target);
    }
    files.add(target);
    return Addresses.ofSource(target);
  }

  private String place(Node node) {
    int line =
        node.getSourceSpans().isEmpty() ? 0 : node.getSourceSpans().getFirst().getLineIndex();
    return page.source() + ":" + (line + 1) + ": ";
  }
}
