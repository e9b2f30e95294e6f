package org.urbi.site;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;

/** The documentation of a project, as a site. */
public final class Site {
  private static final Path START = Path.of("README.md");
  private static final Path DOCUMENTATION = Path.of("docs");
  private static final Path CONTENTS = DOCUMENTATION.resolve("contents.md");
  private static final List<String> COPIED =
      List.of(
          "style.css",
          "site.js",
          "libraries/minisearch.js",
          "libraries/licenses/minisearch-7.2.0.txt");

  private final Path project;
  private final Map<Path, Page> pages = new TreeMap<>();
  private final Set<Path> copies = new TreeSet<>();
  private final Set<Path> files = new TreeSet<>();
  private final List<Links.Anchor> anchors = new ArrayList<>();
  private final List<String> mistakes = new ArrayList<>();

  private Site(Path project) {
    this.project = project;
  }

  /**
   * Makes a site.
   *
   * @param project where {@code README.md} and {@code docs} are
   * @param folder where the site is to be, which is made
   * @param version what it is the documentation of
   * @throws SiteException if a link leads nowhere, or no link to a page
   * @throws IOException if something cannot be read or written
   */
  public static void make(Path project, Path folder, String version)
      throws IOException, SiteException {
    Site site = new Site(project);
    site.read();
    site.check();
    site.write(folder, version);
  }

  private void read() throws IOException {
    Deque<Path> waiting = new ArrayDeque<>(List.of(START, CONTENTS));
    while (!waiting.isEmpty()) {
      Path source = waiting.remove();
      if (pages.containsKey(source)) {
        continue;
      }
      Page page = Page.read(project, source);
      Links links = Links.of(project, page);
      pages.put(source, page);
      waiting.addAll(links.pages);
      copies.addAll(links.copies);
      files.addAll(links.files);
      anchors.addAll(links.anchors);
      mistakes.addAll(links.mistakes);
    }
  }

  private void check() throws IOException, SiteException {
    for (Links.Anchor anchor : anchors) {
      Page page = pages.get(anchor.page());
      if (page != null && !page.has(anchor.id())) {
        mistakes.add(anchor.place() + anchor.page() + " has no #" + anchor.id());
      }
    }
    try (Stream<Path> all = Files.walk(project.resolve(DOCUMENTATION))) {
      all.map(project::relativize)
          .filter(file -> Addresses.isPage(file) && !pages.containsKey(file))
          .sorted()
          .forEach(file -> mistakes.add(file + ":1: no page has a link to this one"));
    }
    if (!mistakes.isEmpty()) {
      throw new SiteException(mistakes);
    }
  }

  private void write(Path folder, String version) throws IOException {
    Page contents = page(CONTENTS);
    Frame frame = new Frame(Contents.of(contents), version);
    for (Page page : pages.values()) {
      String html = PageRenderer.html(page);
      String title = page.source().equals(START) ? "Urbi" : page.title();
      write(
          folder, page.address(), frame.html(page.address(), title, html, page.sections().list()));
    }
    Deque<Path> waiting = new ArrayDeque<>(files);
    while (!waiting.isEmpty()) {
      Path source = waiting.remove();
      Set<Path> others = new TreeSet<>();
      String html = Sources.html(project, source, others);
      String address = Addresses.ofSource(source);
      write(folder, address, frame.html(address, source.toString(), html, List.of()));
      others.stream().filter(files::add).forEach(waiting::add);
    }
    for (Path copy : copies) {
      Path target = folder.resolve(Addresses.ofCopy(copy));
      Files.createDirectories(target.getParent());
      Files.copy(project.resolve(copy), target);
    }
    for (String name : COPIED) {
      write(folder, name, Frame.resource(name));
    }
    write(folder, "search-data.js", SearchData.of(pages.values()));
  }

  private Page page(Path source) {
    Page page = pages.get(source);
    if (page == null) {
      throw new IllegalStateException(source + " was read first");
    }
    return page;
  }

  private static void write(Path folder, String address, String text) throws IOException {
    Path file = folder.resolve(address);
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }

  /**
   * Makes the site of a project.
   *
   * @param args the project, the folder of the site, the version
   */
  public static void main(String[] args) {
    try {
      make(Path.of(args[0]), Path.of(args[1]), args[2]);
    } catch (SiteException e) {
      e.mistakes().forEach(line -> System.err.println("site: " + line));
      System.exit(1);
    } catch (IOException | UncheckedIOException e) {
      System.err.println("site: " + e);
      System.exit(1);
    }
  }
}
