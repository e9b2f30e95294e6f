package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

/** How dialogues are read and compared. */
class TranscriptFormatTest {

  @Test
  void timeStampsTellOutputFromInput() {
    Transcript transcript =
        Transcript.parse(
            """
            // A comment.
            [1, 2];
            [00000000] [1, 2]
            echo("a\\nb");
            [00000000] *** a
            [:]b
            gone;
            [00000000:error] !!! lookup failed: gone
            """);
    assertEquals("// A comment.\n[1, 2];\necho(\"a\\nb\");\ngone;\n", transcript.input());
    assertEquals(
        List.of(
            "[00000000] [1, 2]",
            "[00000000] *** a",
            "[:]b",
            "[00000000:error] !!! lookup failed: gone"),
        transcript.expected());
    assertTrue(transcript.hasInput());
    assertFalse(Transcript.parse("// A comment.\n\n").hasInput());
  }

  @Test
  void timesAreComparedOnRequest() {
    String answer = "[00001250:error] !!! a.u:3.1-4: lookup failed: gone\n";
    assertEquals(
        List.of("[00000000:error] !!! a.u:3.1-4: lookup failed: gone"),
        Transcript.parse("gone;").answeredLines(answer));
    assertEquals(
        List.of("[00001250:error] !!! a.u:3.1-4: lookup failed: gone"),
        Transcript.parse("// exact-times\ngone;").answeredLines(answer));
  }

  @Test
  void locationsAreComparedUnlessAReasonIsGiven() {
    String answer = "[00001250:error] !!! a.u:3.1-4: lookup failed: gone\n";
    assertEquals(
        List.of("[00000000:error] !!! lookup failed: gone"),
        Transcript.parse("// any-locations: the line differs\ngone;").answeredLines(answer));
    assertThrows(
        IllegalArgumentException.class, () -> Transcript.parse("// any-locations:\ngone;"));
  }

  @Test
  void locationsOfCallersAreLocationsToo() {
    assertEquals(
        List.of("[00000000:error] !!!    called from: f", "[00000000:error] !!! 1.5: odd"),
        plain(
            "[00000007:error] !!!    called from: 2.1-3.4: f",
            "[00000007:error] !!! 4.1: 1.5: odd"));
  }

  @Test
  void addressesAreComparedByIdentity() {
    assertEquals(
        plain("[00000000] Object_0x1", "[00000000] 0x2", "[00000000] 0x1"),
        plain("[00000000] Object_0xAF", "[00000000] 0xB", "[00000000] 0xAF"));
    assertNotEquals(
        plain("[00000000] 0x1", "[00000000] 0x1"), plain("[00000000] 0x1", "[00000000] 0x2"));
    assertNotEquals(
        plain("[00000000] 0x1", "[00000000] 0x2"), plain("[00000000] 0x1", "[00000000] 0x1"));
  }

  @Test
  void linesWithoutTimeStampContinueTheLineBefore() {
    assertEquals(plain("[00000000] *** a", "[:]  b"), plain("[00000000] *** a", "  b"));
  }

  @Test
  void numbersOfJobsAndAnonymousTagsDoNotCount() {
    assertEquals(
        plain("[00000000] Job<shell_1>", "[00000000] Tag<tag_8>"),
        plain("[00000000] Job<shell_2>", "[00000000] Tag<tag_9>"));
  }

  @Test
  void differencesAreShownLineByLine() {
    assertEquals(
        """
        --- expected
        +++ answered
          a
        - b
        + x
          c
        + d
        """,
        LineDifference.of(List.of("a", "b", "c"), List.of("a", "x", "c", "d")));
  }

  private static List<String> plain(String... lines) {
    return OutputNormalizer.comparable(String.join("\n", lines).lines().toList(), false, false);
  }
}
