package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.trust.Role;

/** A client leaves, and very much ends with it, in pieces between which others run. */
class LargeEndTest {
  @TempDir Path folder;

  private static final String LARGE =
      """
      var Global.done = 0 | var Global.reacted = 0 | var Global.E = Event.new | var Global.x = 0;
      for& (800) { try { sleep(1h) } finally { Global.done += 1 } },
      for| (800) { at (Global.E?) Global.reacted += 1 | at (Global.x > 0) Global.reacted += 1 };
      for| (800) detach({ loop { sleep(1ms); Global.reacted += 1 - 1 } });
      """;

  @Test
  void nothingReactsAnyMoreAndAReplayDoesTheSame() {
    Path recording = folder.resolve("run");
    try (Kernel kernel = Kernel.builder().log(line -> {}).record(recording).start()) {
      TestClient judge = new TestClient(kernel, Role.OWNER);
      TestClient large = new TestClient(kernel, Role.OWNER);
      large.say(LARGE);
      large.say("1;");
      large.connection().close();
      assertEquals("0", judge.say("Global.E! | Global.x = 1 | Global.reacted;"));
      judge.say("waituntil (Global.done == 800);");
      assertEquals("0", judge.say("Global.reacted;"));
      assertEquals("800", judge.say("Global.done;"));
    }
    ReplayedRun.check(recording);
  }
}
