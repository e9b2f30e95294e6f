package org.urbi.kernel.library.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** That nothing in a text about a type can be left out unnoticed. */
class CompletenessTest {
  private static final String TEXT =
      """
      # Span

      From here to there.

      ## Ends

      ### `begin`, `init`

      ```urbiscript
      # not a heading
      Span.new(1, 2).begin;
      [00000000] 1
      ```
      """;

  private static List<String> missing(String text, Set<String> declared, Set<String> present) {
    return Completeness.missing(Optional.of(TypeText.parse(text)), declared, present);
  }

  @Test
  void completeTextLacksNothing() {
    assertEquals(List.of(), missing(TEXT, Set.of("begin", "init"), Set.of("begin")));
  }

  @Test
  void typeWithoutTextIsFound() {
    assertEquals(
        List.of("nothing is written about it"),
        Completeness.missing(Optional.empty(), Set.of(), Set.of()));
  }

  @Test
  void slotWithoutEntryIsFound() {
    assertEquals(
        List.of("no text about end", "no text about size"),
        missing(TEXT, Set.of("begin", "init", "end"), Set.of("size")));
  }

  @Test
  void entryWithoutSlotIsFound() {
    assertEquals(List.of("no such slot, or twice: begin"), missing(TEXT, Set.of("init"), Set.of()));
  }

  @Test
  void exampleOfSomethingElseIsNone() {
    assertEquals(
        List.of("no example for begin"),
        missing(TEXT.replace("2).begin", "2)"), Set.of("begin", "init"), Set.of()));
  }

  @Test
  void answerIsNoUse() {
    String answered = TEXT.replace("2).begin", "2)").replace("] 1", "] begin");
    assertEquals(
        List.of("no example for begin"), missing(answered, Set.of("begin", "init"), Set.of()));
  }

  @Test
  void typeWithoutPurposeIsFound() {
    assertEquals(
        List.of("it is not said what it is for"),
        missing(TEXT.replace("From here to there.", ""), Set.of("begin", "init"), Set.of()));
  }

  @Test
  void textOfAnotherTypeIsRefused() {
    assertTrue(Completeness.isWellFormed("Span", TEXT));
    assertFalse(Completeness.isWellFormed("Range", TEXT));
  }

  @Test
  void headingWithoutNameIsRefused() {
    assertFalse(Completeness.isWellFormed("Span", TEXT + "\n### begin\n"));
  }
}
