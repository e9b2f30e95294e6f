package org.urbi.kernel.library.reference;

import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.urbi.kernel.ConsoleTranscript;
import org.urbi.lang.grammar.Keywords;

/**
 * Keeps docs/library.md and docs/library what the declarations of the builtins and the texts beside
 * them say, and the examples in those texts true. {@code -Drenew=true} writes pages and answers
 * anew.
 */
class LibraryReferenceTest {
  /** When something was said. */
  private static final Pattern TIME = Pattern.compile("(?m)^\\[\\d+");

  private static final Path DOCS = Path.of("..", "docs");
  private static final Path PAGES = DOCS.resolve("library");
  private static final Path INDEX = DOCS.resolve("library.md");
  private static final Path TEXTS =
      Path.of("src", "main", "resources", "org", "urbi", "kernel", "library", "reference");

  /** A link to another page. */
  private static final Pattern LINK = Pattern.compile("\\]\\(([^)#\\s]+\\.md)");

  private static final String STALE =
      " is stale; renew it: mvn test -pl urbi-kernel -am -Dtest=LibraryReferenceTest"
          + " -Dsurefire.failIfNoSpecifiedTests=false -Drenew=true";

  /** What every type has by itself: its name, and the conversion to it. */
  private static final Set<String> OF_EVERY_TYPE = Set.of("type", "fullType");

  @BeforeAll
  static void renew() throws IOException, URISyntaxException {
    if (!Boolean.getBoolean("renew")) {
      return;
    }
    for (Path text : texts()) {
      renewAnswers(text);
    }
    Files.createDirectories(PAGES);
    for (Path old : files(PAGES)) {
      Files.delete(old);
    }
    for (Map.Entry<String, String> page : LibraryReference.pages().entrySet()) {
      Files.writeString(PAGES.resolve(page.getKey()), page.getValue());
    }
    Files.writeString(INDEX, LibraryReference.index());
  }

  /** Writes what is answered today into a text, and into the copy that the pages are made of. */
  private static void renewAnswers(Path text) throws IOException, URISyntaxException {
    String renewed = Files.readString(text);
    for (Example example : Example.in(renewed)) {
      if (!example.answer().equals(example.output())) {
        renewed = renewed.replace(example.block(), example.renewed().block());
      }
    }
    Files.writeString(text, renewed);
    URL copy =
        requireNonNull(LibraryReference.class.getResource(text.getFileName().toString()), "copied");
    Files.writeString(Path.of(copy.toURI()), renewed);
  }

  @Test
  void pagesAreUpToDate() throws IOException {
    Map<String, String> pages = LibraryReference.pages();
    Set<Path> names = new TreeSet<>();
    for (Map.Entry<String, String> page : pages.entrySet()) {
      Path file = PAGES.resolve(page.getKey());
      assertEquals(page.getValue(), Files.readString(file), file + STALE);
      names.add(file);
    }
    assertEquals(names, new TreeSet<>(files(PAGES)), PAGES + STALE);
    assertEquals(LibraryReference.index(), Files.readString(INDEX), INDEX + STALE);
  }

  private static List<Path> files(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.toList();
    }
  }

  @Test
  void linksLeadToFiles() throws IOException {
    for (Path page : files(PAGES)) {
      for (MatchResult link : LINK.matcher(Files.readString(page)).results().toList()) {
        Path target = PAGES.resolve(link.group(1));
        assertTrue(Files.exists(target), () -> page + " leads to " + target);
      }
    }
  }

  @Test
  void everyTypeIsInTheIndexOnce() {
    List<String> listed =
        LibraryReference.topics()
            .lines()
            .filter(line -> line.startsWith("* "))
            .map(line -> line.substring(2))
            .sorted()
            .toList();
    assertEquals(List.copyOf(LibraryReference.types().keySet()), listed);
  }

  /** Every text is about a type: a misspelled file would be about none. */
  @Test
  void everyTextIsAboutAType() throws IOException {
    Set<String> pages = LibraryReference.pages().keySet();
    for (Path text : files(TEXTS)) {
      String file = text.getFileName().toString();
      if (file.equals("index.md")) {
        continue;
      }
      assertTrue(pages.contains(file), () -> "no type: " + text);
      String type = file.substring(0, file.length() - ".md".length());
      assertTrue(Completeness.isWellFormed(type, Files.readString(text)), text::toString);
    }
  }

  /** No slot of a type can be forgotten. */
  @Test
  void everythingIsExplainedWithAnExample() {
    Map<String, Set<String>> slots = slots();
    LibraryReference.types()
        .forEach((name, type) -> {
          List<String> missing =
              Completeness.missing(
                  TypeText.of(name), type.names(), slots.getOrDefault(name, Set.of()));
          assertEquals(List.of(), missing, name);
        });
  }

  /** Three slashes have it in the reference, two say that it is for the library alone. */
  @Test
  void whatLibrariesInUrbiscriptDefineIsSaidToBeForSomebody() {
    for (ScriptPage page : ScriptPage.all()) {
      assertEquals(List.of(), page.silent(), "a comment /// or // is missing above");
      assertTrue(page.markdown().contains("\n## "), page::markdown);
    }
  }

  /** PagesTest runs them, since some need modules. */
  @Test
  void eachPartOfALibraryInUrbiscriptHasAnExample() {
    for (ScriptPage page : ScriptPage.all()) {
      assertEquals(List.of(), page.missing());
    }
  }

  @Test
  void everyKeywordIsExplainedWithAnExample() {
    assertEquals(
        List.of(), Completeness.missing(TypeText.of(HelpTexts.KEYWORDS), Keywords.all(), Set.of()));
  }

  /** The slots that each type has in a kernel, but for those that hold other types. */
  private static Map<String, Set<String>> slots() {
    Set<String> types = LibraryReference.types().keySet();
    StringBuilder program = new StringBuilder();
    for (String type : types) {
      String path = type.equals("package") ? "'package'" : type;
      program.append("echo(\"%s \" + %s.localSlotNames.join(\" \"))|;\n".formatted(type, path));
    }
    Map<String, Set<String>> slots = new TreeMap<>();
    for (String line : ConsoleTranscript.run(program.toString()).lines().toList()) {
      if (line.contains("] *** ")) {
        List<String> words = List.of(line.substring(line.indexOf("*** ") + 4).split(" "));
        String type = words.getFirst();
        Set<String> names = new TreeSet<>(words.subList(1, words.size()));
        names.removeIf(name ->
            types.contains(name)
                || types.contains(type + "." + name)
                || OF_EVERY_TYPE.contains(name)
                || name.equals("as" + type.substring(type.lastIndexOf('.') + 1)));
        slots.put(type, names);
      }
    }
    return slots;
  }

  @TestFactory
  Stream<DynamicTest> examplesAnswerAsShown() throws IOException {
    return texts().stream()
        .map(text -> DynamicTest.dynamicTest(text.getFileName().toString(), () -> check(text)));
  }

  private static void check(Path text) throws IOException {
    for (Example example : Example.in(Files.readString(text))) {
      UnaryOperator<String> shown =
          example.waitsForPrograms()
              ? answer -> TIME.matcher(answer).replaceAll("[")
              : UnaryOperator.identity();
      assertEquals(
          shown.apply(example.output()),
          shown.apply(example.answer()),
          () -> text + ":\n" + example.block());
    }
  }

  /** The texts about types, and not those about libraries to be loaded. */
  private static List<Path> texts() throws IOException {
    return files(TEXTS).stream()
        .filter(file -> !file.endsWith("index.md") && !file.toString().endsWith(".u.md"))
        .sorted()
        .toList();
  }
}
