package org.urbi.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.urbi.bridge.CxxCompiler.Run;

/** The headers by themselves, without a JVM. */
class HeadersTest {
  private static final Path UNIT = Path.of("src", "test", "native", "unit.cc").toAbsolutePath();

  private static Path program(String compiler, String name, String... options) throws IOException {
    assumeTrue(CxxCompiler.exists(compiler), "no " + compiler);
    Files.createDirectories(CxxCompiler.MADE);
    Path program = CxxCompiler.MADE.resolve(name);
    CxxCompiler.compileProgram(compiler, program, UNIT, options);
    return program;
  }

  /** No leak, no access to what has been freed. */
  @Test
  void addressSanitizer() throws IOException {
    Path program = program("g++", "unit-asan", "-g", "-fsanitize=address");
    assertEquals(new Run(0, "0 failures\n"), CxxCompiler.run(List.of(program.toString())));
  }

  /** Other compilers and versions of the language understand them, without a warning. */
  @ParameterizedTest
  @CsvSource({"g++, 20", "g++, 2b", "clang++, 17", "clang++, 2b"})
  void compile(String compiler, String version) throws IOException {
    assumeTrue(CxxCompiler.exists(compiler), "no " + compiler);
    Files.createDirectories(CxxCompiler.MADE);
    CxxCompiler.compileProgram(
        compiler, CxxCompiler.MADE.resolve("none"), UNIT, "-fsyntax-only", "-std=c++" + version);
  }
}
