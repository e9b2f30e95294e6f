package org.urbi.tests.process;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The lanes of jobs that do not live long, in a real browser. */
class StudioTimelineTest {
  private static final String PROGRAM =
      """
      var Global.e = Event.new|;
      var Global.f = Event.new|;
      at (e?) reacting: { sleep(1s); f!; sleep(2s) };
      listening: loop waituntil (f?),
      beating: every (4s) e!,
      """;

  /**
   * The turn of the {@code every} that emits the event is over before anybody can ask for it, and
   * so is the first turn of the reaction: it only begins to sleep.
   */
  @Test
  void jobsThatHaveEndedAreNamedByWhoHasStartedThem(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "")) {
      Browser browser = page.browser();
      String loop = "a job that was started by shell_\\d+: every \\(4s\\) e!";
      browser.await(
          "the first turn of the reaction",
          StudioPage.told("reacting", "started by"),
          text -> text.matches("at_\\d+: ran for [0-9.]+ ms, [0-9.]+ s ago, started by " + loop));
      browser.await(
          "who has started who has woken",
          StudioPage.told("listening", "started by"),
          text -> text.matches(".*, after it had waited for event, woken by " + loop));
    }
  }
}
