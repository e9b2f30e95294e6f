package org.urbi.kernel.node;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;

/** What code of a loop has detached, when the loop ends (manual, "Control", {@code detach}). */
class LoopJobsTest {
  @Test
  void breakEndsIt() {
    ConsoleTranscript.check(
        """
        var log = []|;
        while (true) { detach({ sleep(1s); log << "of while" }); break };
        for (var i : [1, 2]) { detach({ sleep(1s); log << i }); if (i == 2) break };
        loop { detach({ sleep(1s); log << "of loop" }); break };
        sleep(2s);
        log;
        [00002000] []
        """);
  }

  /** An {@code Error} of Java leaves the loop: only a {@code break} ends its jobs. */
  @Test
  void anExhaustedStackLeavesItAlone() {
    ConsoleTranscript.check(
        """
        var log = []|;
        function deep() { deep }|;
        try { while (true) { detach({ sleep(1s); log << "of while" }); deep } } catch (var e) { echo(e.message) };
        [00000000] *** stack space exhausted
        try { for (var i : 3) { detach({ sleep(1s); log << "of for" }); deep } } catch { echo("caught") };
        [00000000] *** caught
        function f() { while (true) { detach({ sleep(1s); log << "of f" }); deep } }|;
        while (true) { try { f } catch { echo("caught") }; detach({ sleep(1s); log << "never" }); break };
        [00000000] *** caught
        sleep(2s);
        log;
        [00002000] ["of while", "of for", "of f"]
        """);
  }
}
