package org.urbi.server.launch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.server.tools.ToolResult;

/** {@code urbi-launch --wait}, while there is no server. */
class WaitTest {
  /** Nobody listens there: the system gives it to no program that asks for any port. */
  private static final int NOBODY = 1;

  @ParameterizedTest
  @ValueSource(strings = {"--remote", "--plugin"})
  void aServerThatNeverComesIsReportedWhenTheTimeIsOver(String mode) throws Exception {
    ToolResult run = ToolResult.of(UrbiLaunch::run, mode, "--wait=1ms", "-P" + NOBODY, "no-module");
    assertEquals(1, run.status());
    assertTrue(run.err().contains("cannot connect to 127.0.0.1:" + NOBODY), run.err());
  }

  @Test
  void whoStartsTheServerHasNoneToWaitFor() {
    ToolResult run = ToolResult.of(UrbiLaunch::run, "--start", "--wait");
    assertEquals(2, run.status());
    assertTrue(run.err().contains("--wait is for --plugin and --remote"), run.err());
  }
}
