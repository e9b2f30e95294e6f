package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Clients, written in Python, that speak the protocol of programs linked with the SDK of Urbi 2.7,
 * and a real server.
 */
class SdkProcessesTest {
  private static final Path SOURCE = Path.of("src", "test", "python");

  private static ServerProcess server;

  @BeforeAll
  static void start(@TempDir Path folder) throws Exception {
    server = ServerProcess.in(folder);
  }

  @AfterAll
  static void stop() throws Exception {
    try (ServerProcess ending = server) {
      assertEquals(0, ending.shutDown(), ending::text);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"BinaryModeTest", "TextModeTest", "PlainClientTest"})
  void oldSdkClientsAreServed(String test) throws Exception {
    ProcessBuilder command =
        new ProcessBuilder("python3", "-B", "-m", "unittest", "test_sdk_client." + test)
            .directory(SOURCE.toFile())
            .redirectErrorStream(true);
    command.environment().put("URBI_PORT", String.valueOf(server.port()));
    Process python = command.start();
    String output = new String(python.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, python.waitFor(), () -> output + server.text());
    assertTrue(output.contains("\nOK"), output);
    assertTrue(!server.text().contains("internal error"), server::text);
  }
}
