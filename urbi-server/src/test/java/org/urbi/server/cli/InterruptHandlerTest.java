package org.urbi.server.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.time.VirtualClock;

/** The interrupt key of the manual's section 21.3.2. */
class InterruptHandlerTest {
  private final List<String> done = new ArrayList<>();
  private final VirtualClock clock = new VirtualClock();

  private InterruptHandler interrupts(boolean session) {
    return new InterruptHandler(
        () -> session,
        () -> done.add("kill foreground"),
        () -> done.add("shutdown"),
        () -> done.add("halt"),
        clock);
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
    clock.advanceTo(1_500_000_000);
    interrupts.interrupted();
    assertEquals(List.of("kill foreground", "kill foreground"), done);
    clock.advanceTo(2_999_999_999L);
    interrupts.interrupted();
    assertEquals("shutdown", done.getLast());
  }

  @Test
  void withoutASessionTheFirstShutsDown() {
    InterruptHandler interrupts = interrupts(false);
    interrupts.interrupted();
    interrupts.interrupted();
    assertEquals(List.of("shutdown", "halt"), done);
  }
}
