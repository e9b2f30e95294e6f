package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.journal.Entry;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.journal.Recorder;
import org.urbi.kernel.journal.RecordingReader;
import org.urbi.kernel.journal.RecordingWriter;
import org.urbi.kernel.journal.Replay;
import org.urbi.kernel.message.Message;

/** A replay is quiet in the same ticks as the run that was recorded. */
class QuietTest {
  /** What happens in a loop that a test has prepared. */
  @FunctionalInterface
  private interface Program {
    void prepare(Loop loop);
  }

  /** Runs the program, and once more from its recording; returns what it says both times. */
  private static List<String> saidTwice(Program program) {
    var file = new ByteArrayOutputStream();
    List<String> recorded;
    try (var writer =
        new RecordingWriter(
            "run",
            file,
            why -> {
              throw new AssertionError(why);
            })) {
      recorded = said(program, new Recorder(beginning(), writer));
    }
    Replay replay = new Replay(new RecordingReader(new ByteArrayInputStream(file.toByteArray())));
    List<String> replayed = said(program, replay);
    assertNull(replay.difference());
    assertEquals(recorded, replayed);
    return recorded;
  }

  private static Entry.RunStarted beginning() {
    return new Entry.RunStarted(
        "", true, 0, 1, 0, List.of(), null, List.of(), "", List.of(), "NONE", null, null, "",
        false);
  }

  private static List<String> said(Program program, Journal journal) {
    Loop loop = new Loop(journal);
    program.prepare(loop);
    List<String> said = loop.run();
    journal.end();
    return said;
  }

  private static void sayQuietAndStop(Loop loop) {
    loop.say("quiet at " + loop.scheduler.now());
    loop.scheduler.stop();
  }

  /** A receiver that says so when it is sent something. */
  private static Message to(Loop loop, String name, Runnable also) {
    return new Message.InputEnded(
        loop.scheduler
            .inbox()
            .register(message -> {
              loop.say(name);
              also.run();
            }));
  }

  /** It comes when the tick has taken its messages, and has nobody to run. */
  @Test
  void whatHasComeButIsNotTakenYet() {
    assertEquals(
        List.of("first", "second", "quiet at 0"),
        saidTwice(loop -> {
          Inbox inbox = loop.scheduler.inbox();
          Message second = to(loop, "second", () -> {});
          inbox.post(to(loop, "first", () -> loop.scheduler.atEndOfTick(() -> inbox.post(second))));
          loop.scheduler.time().whenQuiet(() -> sayQuietAndStop(loop));
        }));
  }

  @Test
  void whatComesOnlyAfterIt() {
    assertEquals(
        List.of("quiet", "news", "quiet at 7"),
        saidTwice(loop -> {
          Message news =
              to(loop, "news", () -> loop.scheduler.time().whenQuiet(() -> sayQuietAndStop(loop)));
          loop.scheduler
              .time()
              .whenQuiet(() -> {
                loop.say("quiet");
                loop.clock.now = 7;
                loop.scheduler.inbox().post(news);
              });
        }));
  }

  @Test
  void timePassesWhileNothingComes() {
    assertEquals(
        List.of("awake", "quiet at 5"),
        saidTwice(loop -> {
          loop.start(job -> {
            job.sleepUntil(5);
            loop.say("awake");
          });
          loop.scheduler.time().whenQuiet(() -> sayQuietAndStop(loop));
        }));
  }
}
