package org.urbi.server.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;

/** The interrupt key of the manual's section 21.3.2. */
class InterruptsTest {
  private final List<String> done = new ArrayList<>();
  private final AtomicReference<Runnable> timer = new AtomicReference<>();

  private Interrupts interrupts(boolean session) {
    return new Interrupts(
        () -> session,
        () -> done.add("kill foreground"),
        () -> done.add("shutdown"),
        () -> done.add("halt"),
        timer::set);
  }

  @Test
  void twoInARowShutDownAndAThirdEndsTheProcess() {
    Interrupts interrupts = interrupts(true);
    interrupts.interrupted();
    interrupts.interrupted();
    interrupts.interrupted();
    assertEquals(List.of("kill foreground", "shutdown", "halt"), done);
  }

  @Test
  void aSecondOneThatIsLateKillsTheForegroundAgain() {
    Interrupts interrupts = interrupts(true);
    interrupts.interrupted();
    timer.get().run();
    interrupts.interrupted();
    assertEquals(List.of("kill foreground", "kill foreground"), done);
  }

  @Test
  void withoutASessionTheFirstShutsDown() {
    Interrupts interrupts = interrupts(false);
    interrupts.interrupted();
    interrupts.interrupted();
    assertEquals(List.of("shutdown", "halt"), done);
  }
}
