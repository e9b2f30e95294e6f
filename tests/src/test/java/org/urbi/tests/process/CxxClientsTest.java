package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.urbi.server.tools.UrbiCertificate;

/** Clients in C++, {@code urbi/uclient.hh} and {@code urbi/usyncclient.hh}, with a real server. */
class CxxClientsTest {
  private static final int TERMINATED = 143;
  private static final String ASAN = "-fsanitize=address";
  private static final Path SOURCE = Path.of("src", "test", "native", "clients.cc");

  @TempDir Path folder;

  /** By itself, what is compiled can be kept by ccache. */
  private Path compile() throws Exception {
    Path object = folder.resolve("clients.o");
    Path program = folder.resolve("clients");
    CxxModules.compileProgram("g++", SOURCE, object, "-std=c++17", "-g1", ASAN, "-c");
    CxxModules.compileProgram("g++", object, program, ASAN);
    return program;
  }

  /** Nothing goes wrong, with memory neither. */
  @Test
  void clientsOfTheSdkWork() throws Exception {
    Path program = compile();
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
      String refusal = tls("URBI_TLS=1", program, "localhost", server.port());
      assertTrue(refusal.startsWith("the server has not answered in TLS"), refusal);
      server.terminate();
      assertEquals(TERMINATED, server.awaitEnd(), server::text);
    }
    clientsSpeakTls(program);
  }

  private void clientsSpeakTls(Path program) throws Exception {
    Path own = identity("own", "localhost", "127.0.0.1");
    String[] options = {"--tls-certificate", own + ".crt", "--tls-key", own + ".key"};
    try (ServerProcess server = ServerProcess.in(folder, options)) {
      String trusting = "URBI_TLS_CA=" + own + ".crt";
      assertEquals("0 failures\n", tls(trusting, program, "localhost", server.port()));
      assertEquals("0 failures\n", tls(trusting, program, "127.0.0.1", server.port()));
      String stranger = tls("URBI_TLS=1", program, "localhost", server.port());
      assertTrue(stranger.startsWith("the server's certificate is not trusted"), stranger);
      Path other = identity("other", "localhost");
      String wrong = tls("URBI_TLS_CA=" + other + ".crt", program, "localhost", server.port());
      assertTrue(wrong.startsWith("the server's certificate is not trusted"), wrong);
      String none = tls("URBI_TLS_CA=none", program, "localhost", server.port());
      assertEquals("cannot read the certificate to be trusted, none\n", none);
    }
    Path robot = identity("robot", "robot.example");
    String[] named = {"--tls-certificate", robot + ".crt", "--tls-key", robot + ".key"};
    try (ServerProcess server = ServerProcess.in(folder, named)) {
      String trusting = "URBI_TLS_CA=" + robot + ".crt";
      String refusal = "the server's certificate is for another name\n";
      assertEquals(refusal, tls(trusting, program, "localhost", server.port()));
      assertEquals(refusal, tls(trusting, program, "127.0.0.1", server.port()));
    }
  }

  private Path identity(String name, String... hosts) {
    List<String> words = new ArrayList<>(List.of(folder.resolve(name).toString()));
    words.addAll(List.of(hosts));
    PrintStream nowhere = new PrintStream(OutputStream.nullOutputStream());
    assertEquals(0, UrbiCertificate.run(words.toArray(String[]::new), nowhere, System.err));
    return folder.resolve(name);
  }

  /** What the program says: nothing but the result, or why it cannot connect. */
  private static String tls(String setting, Path program, String host, int port) throws Exception {
    String command = "exec env \"$@\" 2>/dev/null";
    return CxxModules.output(
        "sh", "-c", command, "sh", setting, program.toString(), "--tls", host, "" + port);
  }

  @ParameterizedTest
  @CsvSource({"g++, 23", "clang++, 17", "clang++, 2b"})
  void otherCompilers(String compiler, String version) throws Exception {
    Path none = folder.resolve("none");
    CxxModules.compileProgram(compiler, SOURCE, none, "-std=c++" + version, "-fsyntax-only");
  }
}
