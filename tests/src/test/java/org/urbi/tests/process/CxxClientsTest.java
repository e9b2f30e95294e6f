package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Clients in C++, {@code urbi/uclient.hh} and {@code urbi/usyncclient.hh}, with a real server. */
class CxxClientsTest {
  private static final Path SOURCE = Path.of("src", "test", "native", "clients.cc");

  @TempDir Path folder;

  private Path compile(String compiler, String... options) throws Exception {
    Path program = folder.resolve("clients");
    CxxModules.compileProgram(compiler, SOURCE, program, options);
    return program;
  }

  /** Nothing goes wrong, with memory neither. */
  @Test
  void clientsOfTheSdkWork() throws Exception {
    Path program = compile("g++", "-std=c++17", "-g", "-fsanitize=address");
    try (ServerProcess server = ServerProcess.in(folder)) {
      assertEquals(
          "0 failures\n", CxxModules.output(program.toString(), String.valueOf(server.port())));
      assertEquals(0, server.shutDown(), server::text);
    }
  }

  @ParameterizedTest
  @CsvSource({"g++, 23", "clang++, 17", "clang++, 2b"})
  void otherCompilers(String compiler, String version) throws Exception {
    compile(compiler, "-std=c++" + version, "-fsyntax-only");
  }
}
