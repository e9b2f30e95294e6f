package org.urbi.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.fail;

import org.junit.jupiter.api.Test;

/** Native code that starts its UObjects gets an exit status, whatever happens. */
class NativeProgramTest {
  @Test
  void runsAsSoonAsItIsConnected() {
    assertEquals(
        0,
        NativeProgram.start(
            onRunning -> {
              onRunning.run();
              return 3;
            },
            false,
            Thread::start));
  }

  @Test
  void whatEndsBeforeItIsConnectedHasItsStatus() {
    assertEquals(3, NativeProgram.start(onRunning -> 3, false, Thread::start));
  }

  @Test
  void aDefectIsAStatus() {
    assertEquals(
        1,
        NativeProgram.start(
            onRunning -> {
              throw new IllegalStateException("a defect of the test");
            },
            false,
            Thread::start));
  }

  @Test
  void noThreadToBeHadIsAStatus() {
    assertEquals(
        1,
        NativeProgram.start(
            onRunning -> fail("there is no thread that could run it"),
            false,
            thread -> {
              throw new OutOfMemoryError("unable to create native thread");
            }));
  }
}
