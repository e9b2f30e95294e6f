package org.urbi.server.launch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.net.ServerSocket;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.server.tools.ToolResult;

/** {@code urbi-launch --wait}, while there is no server. */
class WaitTest {
  @ParameterizedTest
  @ValueSource(strings = {"--remote", "--plugin"})
  void aServerThatNeverComesIsReportedWhenTheTimeIsOver(String mode) throws Exception {
    int port;
    try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      port = free.getLocalPort();
    }
    ToolResult run = ToolResult.of(UrbiLaunch::run, mode, "--wait=1ms", "-P" + port, "no-module");
    assertEquals(1, run.status());
    assertTrue(run.err().contains("cannot connect to 127.0.0.1:" + port), run.err());
  }

  @Test
  void whoStartsTheServerHasNoneToWaitFor() {
    ToolResult run = ToolResult.of(UrbiLaunch::run, "--start", "--wait");
    assertEquals(2, run.status());
    assertTrue(run.err().contains("--wait is for --plugin and --remote"), run.err());
  }
}
