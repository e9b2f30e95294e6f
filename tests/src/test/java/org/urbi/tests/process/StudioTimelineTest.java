package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The lanes: of jobs that do not live long, and of times in which nobody looked. */
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
          "who has woken, also when that has ended",
          StudioPage.told("listening", "woken by"),
          text -> text.matches(".*, after it had waited for event, woken by at_\\d+: .+"));
    }
  }

  /** Turns are told of jobs in sight only: that none is known does not mean that it has waited. */
  @Test
  void timeInWhichNobodyLookedIsNoneOfWaiting(@TempDir Path folder) throws Exception {
    String program = "beating: every (200ms) 1, resting: sleep(1h),";
    try (StudioPage page = StudioPage.start(folder, program, "")) {
      Browser browser = page.browser();
      String lane = StudioPage.LANE + "const row = %s; return row ? lane(row) : '';";
      String beating = lane.formatted(StudioPage.row("beating"));
      browser.await("all rows", "return !!" + StudioPage.row("resting"), "true"::equals);
      browser.evaluate(span("10000"));
      browser.await("its turns", beating, told -> told.contains("r"));
      browser.evaluate("location.hash = 'code'");
      browser.await(
          "the editor",
          "return !!document.querySelector('[data-room=code]:not([hidden])')",
          "true"::equals);
      page.urbi().send("sleep(1s)| [7];\n");
      page.urbi().awaitText("[7]");
      browser.evaluate("location.hash = 'jobs'");
      browser.await(
          "what is not known",
          beating,
          told -> told.matches("\\?*[a-z]*r[a-z]*\\?{8,}[a-z]*r[a-z]*"));
      String resting = browser.evaluate(lane.formatted(StudioPage.row("resting")));
      assertTrue(resting.matches("\\?*t+\\?{8,}t+"), resting);
    }
  }

  private static String span(String milliseconds) {
    return "const span = document.querySelector('#span'); span.value = '"
        + milliseconds
        + "'; span.dispatchEvent(new Event('change'))";
  }

  /**
   * {@code ;} and {@code |} go on in one lane, {@code &} and {@code ,} open more of them, in which
   * there is something at the same time. All of it is still there when it is over.
   */
  @Test
  void separatorsAreSeenAfterwards(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, "beating: loop 1,", "")) {
      Browser browser = page.browser();
      browser.await("lanes", StudioPage.told("beating", "ran"), text -> text.contains("ran for"));
      browser.evaluate(span("10000"));
      page.urbi()
          .send(
              """
              one: { sleep(1s); 1; 2; 3; sleep(1s) },
              two: { sleep(1s) | 1 | 2 | 3 | sleep(1s) },
              both: { sleep(1s) & sleep(1s) },
              behind: { sleep(1s), sleep(1s) },
              """);
      for (String tag : List.of("one", "two", "both", "behind")) {
        String ended =
            "return %s.length > 0 && %s.length == 0"
                .formatted(StudioPage.rows(tag, ".ended"), StudioPage.rows(tag, ":not(.ended)"));
        browser.await("the end of " + tag, ended, "true"::equals);
      }
      assertEquals(1, lanes(browser, "one").size());
      assertEquals(1, lanes(browser, "two").size());
      assertTrue(goesOn(browser, "one"), "a ; lets others run, and goes on");
      assertFalse(goesOn(browser, "two"), "a | does not let others run");
      assertTrue(areAtOnce(lanes(browser, "both")), lanes(browser, "both")::toString);
      assertTrue(areAtOnce(lanes(browser, "behind")), lanes(browser, "behind")::toString);
      Accessibility.check(browser);
      String state =
          browser.evaluate("return " + StudioPage.rows("one", ".ended") + "[0].innerText");
      assertTrue(state.contains("ended"), state);
      browser.evaluate(StudioPage.rows("one", ".ended") + "[0].click()");
      browser.await("that it is over", StudioPage.text("#job"), t -> t.contains("has ended"));
    }
  }

  private static List<String> lanes(Browser browser, String tag) throws Exception {
    String rows = StudioPage.rows(tag, ".ended");
    return List.of(
        browser.evaluate(StudioPage.LANE + "return " + rows + ".map(lane).join(' ')").split(" "));
  }

  /** Whether two of them have waited for the time at the same time. */
  private static boolean areAtOnce(List<String> lanes) {
    int length = lanes.getFirst().length();
    for (int at = 0; at < length; at++) {
      int place = at;
      if (lanes.stream().filter(each -> each.charAt(place) == 't').count() >= 2) {
        return true;
      }
    }
    return false;
  }

  /** Whether a turn of the job was begun by the one before: in between others could run. */
  private static boolean goesOn(Browser browser, String tag) throws Exception {
    return browser
        .evaluate(
            StudioPage.rows(tag, ".ended")
                + """
                [0].click();
                let all = '';
                for (let step = 0; step < 20; step++) {
                  document.querySelector('#list').dispatchEvent(new KeyboardEvent('keydown', {key: ','}));
                  all += document.querySelector('#turn').textContent;
                }
                return all.includes('ran for') && all.includes('going on');
                """)
        .equals("true");
  }

  /**
   * Of very many that have ended few are kept, but while somebody looks at them all of them are.
   */
  @Test
  void whoPausesLosesNothing(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, "many: for& (12) sleep(1h),", "")) {
      Browser browser = page.browser();
      browser.evaluate(StudioPage.type("#filter", "many"));
      String alive = "return %s.length".formatted(StudioPage.rows("many", ":not(.ended)"));
      String ended = "return %s.length".formatted(StudioPage.rows("many", ".ended"));
      browser.await("all jobs", alive, "13"::equals);
      browser.evaluate("document.querySelector('#pause').click()");
      browser.evaluate("document.querySelector('[data-tag=many] .danger').click()");
      browser.await("their end", alive, "0"::equals);
      assertEquals("13", browser.evaluate(ended));
      browser.evaluate("document.querySelector('#pause').click()");
      browser.await("the latest ones, and who has started them", ended, "9"::equals);
    }
  }

  /** What no test can wait for: a flood of turns and ends, and turns that the server has lost. */
  @Test
  void floodsAreForgottenAndLossesAreKnown(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, "", "")) {
      Browser browser = page.browser();
      browser.evaluate("import('./jobs.js').then(({Jobs}) => (window.Jobs = Jobs))");
      browser.await("the module", "return !!window.Jobs", "true"::equals);
      String begin =
          """
          const jobs = new window.Jobs();
          const job = (number, starter) =>
            ({number, starter, name: '', code: '', place: '', lobby: 'L', waits: 'time', frozen: false, tags: [], share: 0});
          const view = (machine, more) =>
            jobs.take({machine, jobs: [], gone: [], tags: [], tagsGone: [], turns: [], complete: true, ...more});
          view(0, {jobs: [job(5, 0)], traced: [[5, 0]]});
          """;
      assertEquals(
          "time,,time,,time",
          browser.evaluate(
              begin
                  + """
                  view(100, {turns: [[5, [], 50, 60, 'time', 0]]});
                  view(400, {lostUntil: 300, turns: [[5, [], 350, 360, 'time', 0]], traced: []});
                  view(500, {});
                  view(600, {traced: [[5, 600]]});
                  view(700, {turns: [[5, [], 650, 660, 'time', 0]]});
                  return [55, 200, 340, 500, 640].map((time) => jobs.tracks.get(5).did(time));
                  """));
      assertEquals(
          "time,,1001",
          browser.evaluate(
              begin
                  + """
                  view(10, {turns: [[5, [], 5, 6, 'time', 0]]});
                  jobs.held = 10;
                  const turns = Array.from({length: 100000}, (none, i) => [5, [], 11 + i, 11.5 + i, 'time', 0]);
                  view(100010, {turns});
                  const track = jobs.tracks.get(5);
                  const kept = track.all.length;
                  if (kept > 20001) throw new Error(`${kept} are kept`);
                  const known = [track.did(5.5), track.did(11.2)];
                  jobs.held = null;
                  view(200000, {jobs: Array.from({length: 5000}, (none, i) => job(10 + i, 10 + i - 1))});
                  view(200001, {gone: Array.from({length: 5000}, (none, i) => 10 + i)});
                  return [...known, jobs.rows.size];
                  """));
    }
  }
}
