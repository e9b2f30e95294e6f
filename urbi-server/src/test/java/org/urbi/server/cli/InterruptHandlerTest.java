package org.urbi.server.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;

/** The interrupt key of the manual's section 21.3.2. */
class InterruptHandlerTest {
  private final List<String> done = new ArrayList<>();
  private final AtomicReference<Runnable> timer = new AtomicReference<>();

  private InterruptHandler interrupts(boolean session) {
    return new InterruptHandler(
        () -> session,
        () -> done.add("kill foreground"),
        () -> done.add("shutdown"),
        () -> done.add("halt"),
        timer::set);
  }

  @Test
  void secondInterruptShutsDownAndThirdEndsTheProcess() {
    InterruptHandler interrupts = interrupts(true);
    interrupts.interrupted();
    interrupts.interrupted();
    interrupts.interrupted();
    assertEquals(List.of("kill foreground", "shutdown", "halt"), done);
  }

  @Test
  void lateSecondInterruptKillsTheForegroundAgain() {
    InterruptHandler interrupts = interrupts(true);
    interrupts.interrupted();
    timer.get().run();
    interrupts.interrupted();
    assertEquals(List.of("kill foreground", "kill foreground"), done);
  }

  @Test
  void withoutASessionTheFirstShutsDown() {
    InterruptHandler interrupts = interrupts(false);
    interrupts.interrupted();
    interrupts.interrupted();
    assertEquals(List.of("shutdown", "halt"), done);
  }
}
