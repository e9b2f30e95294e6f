package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.DynamicContainer.dynamicContainer;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicNode;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.urbi.tests.KernelSession.BackEnd;
import org.urbi.tests.KernelSession.InputMode;

/**
 * Holds every dialogue of {@code src/test/resources/transcripts} with a kernel in virtual time, on
 * both back ends, fed at once and byte by byte. One file is one behaviour and one test.
 */
class TranscriptTest {
  /** The folders that must not be empty. */
  private static final Set<String> CHAPTERS =
      Set.of(
          "02_getting_started",
          "07_first_steps",
          "08_objects_and_values",
          "09_flow_control",
          "10_functions_and_scopes",
          "11_object_programming",
          "12_functional_programming",
          "13_parallelism",
          "14_events",
          "22_language/assertions",
          "22_language/control",
          "22_language/enumerations",
          "22_language/exceptions",
          "22_language/functions",
          "22_language/objects",
          "22_language/operators",
          "22_language/parallel",
          "22_language/patterns",
          "22_language/scopes",
          "22_language/separators",
          "22_language/syntax",
          "22_tag",
          "22_trajectories");

  @TestFactory
  Stream<DynamicNode> transcripts() {
    return Transcripts.byFolder().entrySet().stream().map(TranscriptTest::folder);
  }

  @Test
  void everyChapterHasTranscripts() {
    Set<String> missing = new TreeSet<>(CHAPTERS);
    missing.removeAll(Transcripts.byFolder().keySet());
    assertEquals(Set.of(), missing, "folders without a transcript");
  }

  @Test
  void everyTranscriptIsNamedAsASentence() {
    for (List<Path> files : Transcripts.byFolder().values()) {
      for (Path file : files) {
        assertTrue(
            file.getFileName().toString().matches("[a-zA-Z0-9]+(_[a-zA-Z0-9]+)+\\.u-session"),
            file.toString());
      }
    }
  }

  private static DynamicNode folder(Map.Entry<String, List<Path>> folder) {
    return dynamicContainer(folder.getKey(), folder.getValue().stream().map(TranscriptTest::test));
  }

  private static DynamicTest test(Path file) {
    return dynamicTest(Transcripts.sentence(file), file.toUri(), () -> hold(Transcript.read(file)));
  }

  private static void hold(Transcript transcript) {
    assertTrue(transcript.hasInput(), "nothing is fed");
    assertFalse(transcript.expected().isEmpty(), "nothing is expected");
    for (BackEnd backEnd : BackEnd.values()) {
      for (InputMode feeding : InputMode.values()) {
        String mode = backEnd + ", " + feeding;
        String output =
            assertTimeoutPreemptively(
                TestTimeout.LONG,
                () -> KernelSession.run(backEnd, feeding, transcript.input()),
                () -> mode + ": no end after " + TestTimeout.LONG);
        List<String> expected = transcript.expectedLines();
        List<String> answered = transcript.answeredLines(output);
        if (!expected.equals(answered)) {
          fail(mode + "\n" + LineDifference.of(expected, answered));
        }
      }
    }
  }
}
