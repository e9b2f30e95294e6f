package org.urbi.kernel.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import urbi.wire.WireException;

/** Whose mistake it is that something was thrown at input. */
class InputFailureTest {
  @Test
  void malformedInputIsThatOfTheOtherProcess() {
    assertEquals(
        "the remote process does not keep to the protocol: too short",
        InputFailure.text(new WireException("too short")));
    assertEquals(
        "the remote process does not keep to the protocol: no such kind",
        InputFailure.text(new IllegalArgumentException("no such kind")));
  }

  @Test
  void defectIsOurs() {
    String text = InputFailure.text(new NullPointerException("of the test"));
    assertTrue(text.startsWith("internal error"), text);
  }
}
