package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import org.junit.jupiter.api.Test;

/** What is left when the JVM of the tests is killed. */
class GuardianTest {
  private static final int KILLED = 128 + 9;

  /** It does not end when it is told to. */
  private static Process stubborn() throws IOException {
    return new ProcessBuilder("/bin/sh", "-c", "trap '' HUP TERM; read -r never").start();
  }

  @Test
  void allThatHasNotEndedIsKilled() throws Exception {
    Process first = stubborn();
    Process ended = stubborn();
    Process last = stubborn();
    Process other = stubborn();
    try (Guardian guardian = new Guardian()) {
      guardian.guard(first);
      guardian.guard(ended);
      guardian.guard(last);
      ended.getOutputStream().close();
      ended.waitFor();
    }
    assertEquals(KILLED, first.waitFor());
    assertEquals(KILLED, last.waitFor());
    assertTrue(other.isAlive());
    other.destroyForcibly();
  }
}
