package org.urbi.sim.physics.ode4j;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.ode4j.ode.internal.ErrorHandler;

class JavaOdeTest {
  /** At a terminal it would be between what somebody types. */
  @Test
  void whatTheSolverRemarksIsNotShown() {
    new JavaOde();
    PrintStream before = System.err;
    ByteArrayOutputStream shown = new ByteArrayOutputStream();
    System.setErr(new PrintStream(shown, true, StandardCharsets.UTF_8));
    try {
      ErrorHandler.dMessage(3, "LCP internal error, s <= 0 (s=%.4e)", 0.0);
    } finally {
      System.setErr(before);
    }
    assertEquals("", shown.toString(StandardCharsets.UTF_8));
  }
}
