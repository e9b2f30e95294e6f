package org.urbi.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The examples: each compiles without a warning, and answers as its dialogue says. */
class ExamplesTest {
  @ParameterizedTest
  @ValueSource(
      strings = {
        "adder",
        "camera",
        "machine",
        "point",
        "servo",
        "servohub",
        "sound",
        "tracker",
        "zerocopy"
      })
  void dialogue(String name) throws IOException {
    Path library = CxxCompiler.library(CxxCompiler.EXAMPLES.resolve(name + ".uob"), name);
    Path dialogue = CxxCompiler.EXAMPLES.resolve(name + ".u");
    assertEquals(
        String.join("\n", Dialogue.expected(dialogue)),
        String.join("\n", Dialogue.actual(dialogue, library)));
  }
}
