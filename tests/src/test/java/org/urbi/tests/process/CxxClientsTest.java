package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Clients in C++, {@code urbi/uclient.hh} and {@code urbi/usyncclient.hh}, with a real server. */
class CxxClientsTest {
  private static final int TERMINATED = 143;
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
    String token = "0123456789abcdef0123456789abcdef";
    Path tokens = Files.writeString(folder.resolve("tokens"), "owner " + token + " clients\n");
    Files.setPosixFilePermissions(tokens, PosixFilePermissions.fromString("rw-------"));
    String socket = folder.resolve("console").toString();
    // Without a token they could only look.
    String[] options = {
      "--tokens", tokens.toString(), "--default-role", "observer", "--socket", socket
    };
    try (ServerProcess server = ServerProcess.in(folder, options)) {
      String port = String.valueOf(server.port());
      String[] command = {"env", "URBI_TOKEN=" + token, program.toString(), port, socket};
      assertEquals("0 failures\n", CxxModules.output(command));
      server.terminate();
      assertEquals(TERMINATED, server.awaitEnd(), server::text);
    }
  }

  @ParameterizedTest
  @CsvSource({"g++, 23", "clang++, 17", "clang++, 2b"})
  void otherCompilers(String compiler, String version) throws Exception {
    compile(compiler, "-std=c++" + version, "-fsyntax-only");
  }
}
