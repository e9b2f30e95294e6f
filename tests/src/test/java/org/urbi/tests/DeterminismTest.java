package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.urbi.tests.KernelSession.BackEnd;
import org.urbi.tests.KernelSession.InputMode;

/**
 * In virtual time a run is a pure function of its input: the same bytes, time stamps included, a
 * hundred times over and on both back ends.
 */
class DeterminismTest {
  private static final int RUNS = Integer.getInteger("urbi.determinism.runs", 100);

  /** The programs are there to do much at once: less output than this means that they failed. */
  private static final int LEAST_LINES = 20;

  static Stream<Path> programs() {
    return Transcripts.files("determinism", ".u").stream();
  }

  @ParameterizedTest
  @MethodSource("programs")
  void everyRunGivesTheSameBytes(Path file) throws IOException {
    String program = Files.readString(file, StandardCharsets.ISO_8859_1);
    String first = KernelSession.run(BackEnd.TICK_LOOP, InputMode.WHOLE, program);
    assertFalse(first.contains(":error]"), first);
    assertTrue(LEAST_LINES <= first.lines().count(), first);
    for (int run = 0; run < RUNS; run++) {
      for (BackEnd backEnd : BackEnd.values()) {
        String output = KernelSession.run(backEnd, InputMode.WHOLE, program);
        assertEquals(first, output, backEnd + ", run " + run);
      }
    }
  }
}
