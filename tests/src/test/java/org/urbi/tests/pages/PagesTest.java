package org.urbi.tests.pages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.api.DynamicContainer.dynamicContainer;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicContainer;
import org.junit.jupiter.api.DynamicNode;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.tests.KernelSession;
import org.urbi.tests.LineDifference;
import org.urbi.tests.TestTimeout;
import org.urbi.tests.UObjectJars;
import org.urbi.tests.pages.Listing.Kind;

/**
 * Every listing of every page runs, and shows what it gives. {@code -Drenew=true} writes what the
 * sessions answer into the pages instead; {@code -Dpage=NAME} holds only the pages with such names.
 */
class PagesTest {
  private static final Path ROOT = Path.of("..");

  /** The pages of the library have examples with a kernel each: LibraryReferenceTest runs them. */
  private static final Path LIBRARY = ROOT.resolve("docs").resolve("library");

  /** Of these texts it makes pages; those about libraries that are loaded are pages like others. */
  private static final Path LIBRARY_TEXTS =
      ROOT.resolve("urbi-kernel/src/main/resources/org/urbi/kernel/library/reference");

  private static final boolean RENEW = Boolean.getBoolean("renew");
  private static final String ONLY = System.getProperty("page", "");

  @TempDir static Path folder;
  private static Path modules;

  @BeforeAll
  static void makeModules() throws IOException {
    modules = Files.createDirectory(folder.resolve("modules"));
    UObjectJars.pack(ROOT.resolve("sim-devices/target/classes"), modules.resolve("sim.jar"), "");
    Path ros = Files.createDirectory(modules.resolve("urbi")).resolve("ros.jar");
    UObjectJars.pack(ROOT.resolve("urbi-ros/target/classes"), ros, "");
  }

  @TestFactory
  Stream<DynamicNode> everyListingOf() throws IOException {
    List<Path> files = files();
    assertTrue(20 < files.size(), files.toString());
    return files.stream()
        .filter(file -> file.toString().contains(ONLY))
        .map(Page::read)
        .map(PagesTest::tests);
  }

  private static List<Path> files() throws IOException {
    List<Path> files = new ArrayList<>(List.of(ROOT.resolve("README.md")));
    try (Stream<Path> docs = Files.walk(ROOT.resolve("docs"));
        Stream<Path> examples = Files.walk(ROOT.resolve("examples"));
        Stream<Path> texts = Files.list(LIBRARY_TEXTS)) {
      Stream.concat(
              Stream.concat(docs, examples)
                  .filter(file -> file.toString().endsWith(".md") && !file.startsWith(LIBRARY)),
              texts.filter(file -> file.toString().endsWith(".u.md")))
          .sorted()
          .forEach(files::add);
    }
    return files;
  }

  private static DynamicContainer tests(Page page) {
    List<DynamicTest> tests = new ArrayList<>();
    List<Listing> session = page.listings(Kind.SESSION);
    if (!session.isEmpty()) {
      tests.add(dynamicTest("the session", () -> converse(page, session)));
    }
    List<Listing> one = page.listings(Kind.ROS_1);
    if (!one.isEmpty()) {
      tests.add(dynamicTest("the session with ROS 1", () -> converseInOne(page, one)));
    }
    List<Listing> two = page.listings(Kind.ROS_2);
    if (!two.isEmpty()) {
      tests.add(
          dynamicTest(
              "the session with ROS 2", () -> converse(page, two, RosPeers.inTwo(), false)));
    }
    if (!page.listings(Kind.TERMINAL, Kind.BACKGROUND).isEmpty()) {
      tests.add(dynamicTest("the terminal", () -> holdTerminal(page)));
    }
    for (Listing listing : page.listings()) {
      String line = "line " + listing.line();
      switch (listing.kind()) {
        case SEPARATE_SESSION ->
            tests.add(dynamicTest(line, () -> converse(page, List.of(listing))));
        case JAVA -> tests.add(dynamicTest(line, () -> new JavaListings(folder).compile(listing)));
        case CXX -> tests.add(dynamicTest(line, () -> compileCxx(listing)));
        case PROGRAM -> tests.add(dynamicTest(line, () -> run(page, listing)));
        case EXCERPT -> tests.add(dynamicTest(line, () -> findInFile(listing)));
        case SESSION, ROS_1, ROS_2, TERMINAL, BACKGROUND, FILE, MODULE, PRINTED, NOT_RUN -> {}
      }
    }
    return dynamicContainer(ROOT.relativize(page.file()).toString(), tests);
  }

  private static void converseInOne(Page page, List<Listing> listings) throws Exception {
    assumeTrue(RosPeers.areInstalled(), "skipped: there is no ROS 1 on this machine");
    try (RosPeers peers = RosPeers.start(folder)) {
      converse(page, listings, peers.inOne(), false);
    }
  }

  private static void converse(Page page, List<Listing> listings) throws IOException {
    converse(page, listings, "", true);
  }

  /**
   * Holds a session.
   *
   * @param beginning what comes before the listings, and is not shown
   * @param withTimes whether time stamps count: the network takes its time, whatever the clock of
   *     the kernel says
   */
  private static void converse(
      Page page, List<Listing> listings, String beginning, boolean withTimes) throws IOException {
    for (Listing module : page.listings(Kind.MODULE)) {
      new JavaListings(folder).makeModule(module, modules);
    }
    for (Listing file : page.listings(Kind.FILE)) {
      Files.writeString(modules.resolve(file.detail()), file.text());
    }
    PageSession session = PageSession.of(listings);
    byte[] bytes = (beginning + session.program()).getBytes(StandardCharsets.UTF_8);
    // One char per byte, as kernels take and give text.
    String program = new String(bytes, StandardCharsets.ISO_8859_1);
    String output =
        assertTimeoutPreemptively(
            TestTimeout.LONG, () -> KernelSession.runAsReader(modules, ROOT, program));
    byte[] answer = output.getBytes(StandardCharsets.ISO_8859_1);
    List<List<String>> renewed = session.renewed(new String(answer, StandardCharsets.UTF_8));
    if (RENEW) {
      renew(page, listings, renewed);
      return;
    }
    for (int i = 0; i < listings.size(); i++) {
      List<String> shown = PageSession.comparable(listings.get(i).lines(), withTimes);
      List<String> answered = PageSession.comparable(renewed.get(i), withTimes);
      if (!shown.equals(answered)) {
        fail(page.place(listings.get(i)) + "\n" + LineDifference.of(shown, answered));
      }
    }
  }

  /** Writes what was answered into the page. */
  private static void renew(Page page, List<Listing> listings, List<List<String>> renewed)
      throws IOException {
    List<String> text = new ArrayList<>(Files.readAllLines(page.file()));
    for (int i = listings.size() - 1; 0 <= i; i--) {
      Listing listing = listings.get(i);
      List<String> place = text.subList(listing.line(), listing.line() + listing.lines().size());
      place.clear();
      place.addAll(renewed.get(i));
    }
    Files.write(page.file(), text);
  }

  private static void run(Page page, Listing listing) throws IOException {
    int next = page.listings().indexOf(listing) + 1;
    assertTrue(
        next < page.listings().size() && page.listings().get(next).kind() == Kind.PRINTED,
        "what the program prints follows");
    List<String> printed = page.listings().get(next).lines();
    List<String> really = new JavaListings(folder).run(listing);
    assertEquals(printed, really, () -> LineDifference.of(printed, really));
  }

  private static void compileCxx(Listing listing) throws Exception {
    assumeTrue(Files.isExecutable(Path.of("/usr/bin/g++")), "skipped: there is no g++");
    Path source = Files.createTempFile(folder, "listing", ".cc");
    Files.writeString(source, listing.text());
    String headers = ROOT.resolve("include").toString();
    Process compiler =
        new ProcessBuilder("g++", "-fsyntax-only", "-I", headers, source.toString())
            .redirectErrorStream(true)
            .start();
    String messages = new String(compiler.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, compiler.waitFor(), messages);
  }

  /** A file has a listing, but for comments and where lines are broken. */
  private static void findInFile(Listing listing) throws IOException {
    String file = Files.readString(ROOT.resolve(listing.detail()));
    assertTrue(
        codeAlone(file).contains(codeAlone(listing.text())),
        listing.detail() + " has no such code");
  }

  private static String codeAlone(String java) {
    return java.replaceAll("(?s)/\\*.*?\\*/|//[^\n]*|\\s+", "");
  }

  private static void holdTerminal(Page page) throws IOException {
    assumeTrue(
        System.getProperty("urbi.distribution.jars") != null,
        "skipped: ./check runs the commands of pages, with the distribution that it has made");
    try (Terminal terminal = new Terminal(Files.createTempDirectory(folder, "checkout"))) {
      for (Listing listing :
          page.listings(Kind.TERMINAL, Kind.BACKGROUND, Kind.FILE, Kind.MODULE)) {
        try {
          terminal.hold(listing);
        } catch (AssertionError e) {
          throw new AssertionError(page.place(listing) + ": " + e.getMessage(), e);
        }
      }
    }
  }
}
