package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.message.Outcome;

/** How time passes between the ticks, and what the loop hears and knows of the outside. */
class SchedulerTimeTest {
  private static final long SECOND = Loop.SECOND;

  private final Loop loop = new Loop();

  // ------------------------------------------------------------------ time

  @Test
  void simulatedTimeJumpsToTheNextDeadline() {
    loop.start(job -> job.sleepUntil(3_600 * SECOND));
    loop.start(job -> {
      job.sleepUntil(SECOND);
      loop.say("at " + loop.scheduler.now() / SECOND + " in tick " + loop.scheduler.time().cycle());
    });
    assertEquals(List.of("at 1 in tick 3"), loop.run());
    assertEquals(3_600 * SECOND, loop.scheduler.now());
  }

  /** The first cycle after a wait, or of all, does not count. */
  @Test
  void whoNeverWaitsLetsTheSimulatedTimePass() {
    loop.start(job -> {
      spin(job, 1000);
      assertEquals(0, loop.scheduler.now());
      job.yieldNow();
      assertEquals(1_000_000, loop.scheduler.now());
      spin(job, 999);
      assertEquals(1_000_000, loop.scheduler.now());
      job.yieldNow();
      assertEquals(2_000_000, loop.scheduler.now());
      job.sleepUntil(SECOND);
      spin(job, 1000);
      assertEquals(SECOND, loop.scheduler.now());
      job.yieldNow();
      assertEquals(SECOND + 1_000_000, loop.scheduler.now());
    });
    loop.run();
  }

  private static void spin(Job job, int cycles) {
    for (int cycle = 0; cycle < cycles; cycle++) {
      job.yieldNow();
    }
  }

  /** Cycles that are left out because nobody else can run are cycles, too. */
  @Test
  void whoIsAloneAndNeverWaitsLetsTheSimulatedTimePassAsWell() {
    loop.start(job -> {
      for (int cycle = 0; cycle < 1000; cycle++) {
        job.yield();
      }
      assertEquals(0, loop.scheduler.now());
      job.yield();
      assertEquals(1_000_000, loop.scheduler.now());
    });
    loop.run();
  }

  /** Waits that begin in one tick end together, but a long tick uses up none of them. */
  @Test
  void aTickThatTakesLongDoesNotShortenTheWaitsThatBeginInIt() {
    Loop real = new Loop(ManualClock.real());
    real.start(job -> {
      assertEquals(SECOND, real.scheduler.deadline(SECOND));
      real.clock.now += 9_999_999;
      assertEquals(SECOND, real.scheduler.deadline(SECOND));
      real.clock.now += 1;
      assertEquals(SECOND + 10_000_000, real.scheduler.deadline(SECOND));
    });
    real.run();
    assertEquals(List.of(), real.uncaught);
  }

  /** What a kernel does when it has nothing to do. */
  private static class Idle implements Journal {
    Runnable action = () -> {};
    int idle;

    @Override
    public void idle() {
      idle++;
      action.run();
    }
  }

  @Test
  void simulatedTimeStandsStillWhileSomebodyHoldsIt() {
    Idle idle = new Idle();
    Loop held = new Loop(idle);
    idle.action =
        () -> {
          if (idle.idle == 1) {
            held.say("idle");
            held.post(() -> {
              assertEquals(0, held.clock.now());
              held.say("message");
              held.scheduler.time().release();
            });
          }
        };
    held.scheduler.time().hold();
    held.start(job -> {
      for (int tick = 0; tick < 1500; tick++) {
        job.yieldNow();
      }
      assertEquals(0, held.scheduler.now());
      job.sleepUntil(SECOND);
      held.say("at " + held.scheduler.now() / SECOND);
    });
    assertEquals(List.of("idle", "message", "at 1"), held.run());
  }

  /** The message is there when the loop begins to wait, or it would wait for ever. */
  @Test
  void simulatedTimeGoesAtTheMachinesPaceWhileSomethingRealGoesOn() {
    Idle idle = new Idle();
    Loop paced = new Loop(idle);
    paced.scheduler.pace().begin();
    paced
        .scheduler
        .time()
        .whenQuiet(() -> {
          paced.say("quiet");
          paced.scheduler.stop();
        });
    idle.action =
        () -> {
          paced.machine.now = 5 * SECOND;
          paced.post(() -> {
            paced.say("message at " + paced.clock.now() / SECOND);
            paced.scheduler.pace().end();
          });
        };
    assertEquals(List.of("message at 5", "quiet"), paced.run());
  }

  @Test
  void newsAreTakenBeforeTheTimeMovesOn() {
    Idle idle = new Idle();
    Loop busy = new Loop(idle);
    idle.action =
        () -> {
          if (idle.idle == 1) {
            busy.post(() -> busy.say("message at " + busy.clock.now()));
          }
        };
    busy.start(job -> {
      job.sleepUntil(SECOND);
      busy.say("awake");
    });
    assertEquals(List.of("message at 0", "awake"), busy.run());
  }

  /** A real clock is waited for: here until a time that has come when the wait begins. */
  @Test
  void realTimeIsWaitedFor() {
    Loop real = new Loop(ManualClock.real());
    List<Long> waits = new ArrayList<>();
    real.scheduler
        .inbox()
        .listenTo(
            new KernelPoller() {
              @Override
              public Wait begin(long nanoseconds) {
                waits.add(nanoseconds);
                real.clock.now = waits.size() == 1 ? 3 * SECOND : 10 * SECOND;
                return new Wait() {
                  @Override
                  public void await() {}

                  @Override
                  public void wake() {}
                };
              }

              @Override
              public void poll() {
                real.say("hears");
              }

              @Override
              public void pollIfDue(long now) {
                real.say("glances");
              }

              @Override
              public void close() {
                real.say("closes");
              }
            });
    real.start(job -> job.sleepUntil(10 * SECOND));
    assertEquals(List.of("glances", "hears", "hears", "glances", "closes"), real.run());
    assertEquals(List.of(10 * SECOND, 7 * SECOND), waits);
  }

  /** Timers are looked for the more often, the longer the code between two {@code ;} takes. */
  @Test
  void whoIsAloneInRealTimeDelaysTimersByOneTurn() {
    Loop real = new Loop(ManualClock.real());
    real.start(job -> {
      while (real.scheduler.now() < 50_000_000) {
        real.clock.now += 10_000_000;
        job.yield();
      }
    });
    real.start(job -> {
      job.sleepUntil(5_000_000);
      real.say("awake at " + real.scheduler.now());
    });
    assertEquals(List.of("awake at 10000000"), real.run());
  }

  @Test
  void aCheapTurnIsSeldomATick() {
    Loop real = new Loop(ManualClock.real());
    int[] ticks = new int[1];
    int[] yields = new int[1];
    real.scheduler
        .inbox()
        .listenTo(
            new KernelPoller() {
              @Override
              public @Nullable Wait begin(long nanoseconds) {
                return null;
              }

              @Override
              public void poll() {}

              @Override
              public void pollIfDue(long now) {
                ticks[0]++;
              }

              @Override
              public void close() {}
            });
    real.start(job -> {
      for (; real.scheduler.now() < 30_000; yields[0]++) {
        real.clock.now += 10;
        job.yield();
      }
      real.say("ticks " + ticks[0]);
      real.say("cycles " + (real.scheduler.time().cycle() == yields[0] + 1));
      while (real.scheduler.now() < 2_900_000) {
        real.clock.now += 10_000;
        job.yield();
      }
      real.say("ticks " + ticks[0]);
    });
    assertEquals(List.of("ticks 0", "cycles true", "ticks 2"), real.run());
  }

  @Test
  void itIsQuietWhenOnlyAMessageCouldBringMore() {
    Idle idle = new Idle();
    Loop quiet = new Loop(idle);
    idle.action = () -> quiet.say("idle");
    quiet
        .scheduler
        .time()
        .whenQuiet(() -> {
          quiet.say("quiet at " + quiet.scheduler.now() / SECOND);
          if (quiet.said.size() > 3) {
            quiet.scheduler.stop();
          } else {
            quiet.post(() -> quiet.start(job -> quiet.say("job")));
          }
        });
    quiet.start(job -> job.sleepUntil(SECOND));
    assertEquals(List.of("idle", "quiet at 1", "idle", "job", "quiet at 1"), quiet.run());
  }

  @Test
  void whatIsToBeDoneAtTheEndOfAnEmptyTickIsNotWaitedFor() {
    loop.scheduler
        .time()
        .whenQuiet(() ->
            loop.scheduler.atEndOfTick(() -> {
              loop.say("end");
              loop.scheduler.stop();
            }));
    assertEquals(List.of("end"), loop.run());
  }

  // ------------------------------------------------------------------ the outside

  @Test
  void aLookAtTheOutsidePassesTheJournal() {
    List<Object> looks = new ArrayList<>();
    Loop recorded =
        new Loop(
            new Journal() {
              @Override
              public boolean countsChecks() {
                return true;
              }

              @Override
              public <T> T query(Outcome.Work<T> work) throws IOException {
                try {
                  T result = work.run();
                  looks.add(result);
                  return result;
                } catch (Exception e) {
                  throw new IOException(e);
                }
              }
            });
    recorded.clock.now = 17;
    assertEquals(17, recorded.scheduler.measure());
    assertTrue(recorded.scheduler.time().attempt(() -> true));
    assertFalse(recorded.scheduler.time().attempt(() -> false));
    assertEquals(List.of(17L, true, false), looks);
    assertThrows(
        UncheckedIOException.class,
        () ->
            recorded
                .scheduler
                .time()
                .attempt(() -> {
                  throw new IllegalArgumentException();
                }));
  }

  @Test
  void aRecordingCountsHowOftenNobodyLetOthersRun() {
    List<String> asked = new ArrayList<>();
    Journal counting =
        new Journal() {
          @Override
          public boolean countsChecks() {
            return true;
          }

          @Override
          public boolean yieldsToMessages(int turns, boolean news) {
            asked.add(turns + " " + news);
            return turns == 2;
          }
        };
    Loop counted = new Loop(counting);
    assertSame(counting, counted.scheduler.journal());
    counted.start(job -> {
      for (int i = 0; i < 4; i++) {
        counted.say(String.valueOf(counted.scheduler.hasOthers()));
      }
    });
    assertEquals(List.of("false", "false", "true", "false"), counted.run());
    assertEquals(List.of("0 false", "1 false", "2 false", "0 false"), asked);
  }

  @Test
  void aRecordingThatIsOverEndsTheLoopAndIsNotWaitedFor() {
    int[] ticks = new int[1];
    Loop replayed =
        new Loop(
            new Journal() {
              @Override
              public boolean isReplay() {
                return true;
              }

              @Override
              public boolean isOver() {
                return ticks[0] == 3;
              }

              @Override
              public long tick(long now) {
                return 10 * ++ticks[0];
              }

              @Override
              public void idle() {
                ticks[0] = 100;
              }
            });
    replayed.scheduler.time().whenQuiet(() -> {});
    replayed.start(job -> {
      replayed.say("at " + replayed.scheduler.now());
      job.yieldNow();
      replayed.say("at " + replayed.scheduler.now());
      job.yieldNow();
      replayed.say("never");
    });
    assertEquals(List.of("at 10", "at 20"), replayed.run());
  }
}
