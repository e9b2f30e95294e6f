package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.trust.Role;

/**
 * A client who wants more memory at once than there is, a longer list than fits, say, gets an error
 * each time. Nobody is ended for it: the memory is not full.
 */
class TooMuchWantedTest {
  private static final int TIMES = 20;

  @Test
  void whoeverWantsTooMuchAgainAndAgainBearsItAlone() {
    List<String> log = new CopyOnWriteArrayList<>();
    try (Kernel kernel = Kernel.builder().log(log::add).start()) {
      kernel.define("more", arguments -> new byte[Integer.MAX_VALUE]);
      TestClient judge = new TestClient(kernel, Role.OWNER);
      TestClient greedy = new TestClient(kernel, Role.OWNER);
      judge.say("var beats = 0|; every (1ms) { beats += 1 },");
      for (int i = 0; i < TIMES; i++) {
        assertEquals("!!! memory exhausted", greedy.say("more|;").lines().findFirst().orElse(""));
        assertEquals("2", judge.say("1 + 1;"));
      }
      String caught = "for (3) try { more } catch (var e) { echo(e.message) };";
      assertTrue(greedy.say(caught).endsWith("memory exhausted"), "and goes on");
      assertEquals("true", judge.say("{ var was = beats| sleep(10ms)| beats > was };"));
      assertEquals(List.of(), log);
    }
  }
}
