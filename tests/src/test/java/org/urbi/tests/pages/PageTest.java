package org.urbi.tests.pages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.tests.KernelSession;
import org.urbi.tests.pages.Listing.Kind;

/** A listing that nobody runs, or that shows something else, is found. */
class PageTest {
  private static final Path FILE = Path.of("page.md");

  private static Page page(String text) {
    return Page.parse(FILE, text.lines().toList());
  }

  private static List<List<String>> answered(String text) {
    PageSession session = PageSession.of(page(text).listings());
    return session.renewed(
        KernelSession.runAsReader(Path.of("target"), Path.of(".."), session.program()));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "```java\nclass A {}\n```",
        "```\n1;\n```",
        "text\n\n    1;",
        "<!-- listing: sesion -->\n\n    1;",
        "<!-- listing: not run -->\n\n    1;",
        "<!-- listing: not run:  -->\n\n    1;",
        "<!-- listing: terminal: something -->\n\n    $ true",
        "<!-- listing: java -->\n\ntext\n\n    1;",
      })
  void whatIsNotSaidToBeAnythingIsRefused(String text) {
    IllegalArgumentException refused =
        assertThrows(IllegalArgumentException.class, () -> page(text));
    assertTrue(refused.getMessage().startsWith("page.md:"), refused.getMessage());
  }

  @Test
  void listingThatDoesNotEndIsRefused() {
    assertThrows(IllegalArgumentException.class, () -> page("```urbiscript\n1;"));
  }

  @Test
  void listingsAreFoundWithTheirKinds() {
    Page page =
        page(
            """
            ```urbiscript
            1;
            ```

            ```mermaid
            graph
            ```

            <!-- listing: not run: it is dangerous -->

                one

                two
            text
            """);
    assertEquals(
        List.of(Kind.SESSION, Kind.NOT_RUN), page.listings().stream().map(Listing::kind).toList());
    assertEquals("it is dangerous", page.listings().getLast().detail());
    assertEquals(List.of("one", "", "two"), page.listings().getLast().lines());
    assertEquals(11, page.listings().getLast().line());
  }

  @Test
  void answersAreBelowWhatTheyAnswer() {
    String text =
        """
        ```urbiscript
        var x = 1;
        [:]
        at (x == 2) echo("two");
        x = 2|;
        [:]
        foo;
        ```

        ```urbiscript
        sleep(1s);
        x;
        [:]
        // The first line of its listing.
        { sleep(0.5ms); echo("late") },
        ```
        """;
    assertEquals(
        List.of(
            List.of(
                "var x = 1;",
                "[00000000] 1",
                "at (x == 2) echo(\"two\");",
                "x = 2|;",
                "[00000000] *** two",
                "foo;",
                "[00000000:error] !!! 4.1-3: lookup failed: foo (possible misspelling of log)"),
            List.of(
                "sleep(1s);",
                "x;",
                "[00001000] 2",
                "// The first line of its listing.",
                "{ sleep(0.5ms); echo(\"late\") },",
                "[00001000] *** late")),
        answered(text));
  }

  @Test
  void sessionThatEndsTooEarlyIsTold() {
    AssertionError told =
        assertThrows(AssertionError.class, () -> answered("```urbiscript\n1;\nshutdown;\n```\n"));
    assertTrue(told.getMessage().contains("after 0 of 1 exchanges"), told.getMessage());
  }

  @Test
  void addressesDoNotCount() {
    assertEquals(
        PageSession.comparable(List.of("Object.new;", "[00000000] Object_0x1"), true),
        PageSession.comparable(List.of("Object.new;", "[00000000] Object_0x7f3a"), true));
  }
}
