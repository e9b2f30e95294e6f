package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.message.Message;

/** The tick loop: what a tick does, in which order; how it ends. */
class SchedulerTest {
  private static final long SECOND = Loop.SECOND;

  private final Loop loop = new Loop();

  // ------------------------------------------------------------------ a tick

  /** Each starts the next one at once, where no time passes that could end the round. */
  @Test
  void anEndlessChainOfJobsLetsTheOthersRun() {
    int[] length = {0};
    loop.start(job -> lengthen(job, length));
    loop.start(job -> {
      loop.say("after " + length[0]);
      length[0] = Integer.MAX_VALUE;
    });
    assertEquals(List.of("after 1002"), loop.run());
  }

  private void lengthen(Job job, int[] length) {
    if (length[0] < 100_000) {
      length[0]++;
      loop.scheduler.startDetached(
          job.lobby(), job.scope(), "shell", next -> lengthen(next, length));
    }
  }

  @Test
  void aTickTakesMessagesThenTimersThenRunsTheJobsThenEnds() {
    loop.start(job -> {
      loop.scheduler.timers().add(0, () -> loop.say("timer"));
      loop.post(() -> loop.say("message"));
      loop.scheduler.atEndOfTick(() -> {
        loop.say("end of tick");
        loop.scheduler.atEndOfTick(() -> loop.say("still the end"));
      });
      loop.scheduler.startBehind(
          null,
          loop.scheduler.rootScope(),
          "job",
          last -> {
            loop.say("behind in tick " + loop.scheduler.time().cycle());
            loop.start(child -> loop.say("child in tick " + loop.scheduler.time().cycle()));
          });
      loop.scheduler.startAhead(
          null,
          loop.scheduler.rootScope(),
          "job",
          first -> loop.say("ahead in tick " + loop.scheduler.time().cycle()));
      job.yieldNow();
      loop.say("job");
    });
    assertEquals(
        List.of(
            "behind in tick 1",
            "end of tick",
            "still the end",
            "message",
            "timer",
            "ahead in tick 2",
            "job",
            "child in tick 2"),
        loop.run());
  }

  @Test
  void whatIsStartedRunsRightBehindInTheOrderOfTheStarts() {
    loop.start(job -> {
      loop.start(child -> loop.say("one"));
      loop.start(child -> loop.say("two"));
      loop.say("parent");
    });
    loop.start(job -> loop.say("next"));
    assertEquals(List.of("parent", "one", "two", "next"), loop.run());
  }

  @Test
  void whoCanRunAgainDoesSoInTheNextTick() {
    loop.start(job -> {
      assertSame(job, loop.scheduler.running());
      assertEquals(1, loop.scheduler.time().cycle());
      long turn = loop.scheduler.turn();
      job.yieldNow();
      assertEquals(2, loop.scheduler.time().cycle());
      assertTrue(loop.scheduler.turn() > turn);
    });
    loop.run();
    assertNull(loop.scheduler.running());
  }

  @Test
  void everyTurnHasItsNumberAndTheTimeBetweenThemToo() {
    List<Long> turns = new ArrayList<>();
    for (int i = 0; i < 2; i++) {
      loop.start(job -> {
        turns.add(loop.scheduler.turn());
        loop.scheduler.beginTurn();
        turns.add(loop.scheduler.turn());
      });
    }
    loop.scheduler.startBehind(
        null, loop.scheduler.rootScope(), "job", job -> turns.add(loop.scheduler.turn()));
    loop.scheduler.atEndOfTick(() -> turns.add(loop.scheduler.turn()));
    loop.run();
    assertEquals(List.of(1L, 2L, 3L, 4L, 6L, 6L), turns);
  }

  @Test
  void aTimerThatFailsKeepsNoneOfTheOthersFromTheirTurn() {
    RuntimeException first = new IllegalStateException();
    Error second = new StackOverflowError();
    loop.scheduler
        .timers()
        .add(
            0,
            () -> {
              throw first;
            });
    loop.scheduler
        .timers()
        .add(
            0,
            () -> {
              throw second;
            });
    loop.scheduler.timers().add(0, () -> loop.say("third"));
    assertThrows(AssertionError.class, loop::run);
    assertEquals(List.of(first, second), loop.uncaught);
    assertEquals(List.of("third"), loop.said);
  }

  @Test
  void theEndOfATickFailsForNobodyElse() {
    RuntimeException failure = new IllegalStateException();
    loop.scheduler.atEndOfTick(() -> {
      throw failure;
    });
    loop.scheduler.atEndOfTick(() -> loop.say("on"));
    assertThrows(AssertionError.class, loop::run);
    assertEquals(List.of(failure), loop.uncaught);
    assertEquals(List.of("on"), loop.said);
  }

  @Test
  void theEndOfATickIsRepeatedUntilThereIsMemoryForIt() {
    loop.scheduler.memory().setRelief(() -> loop.say("asked"));
    int[] tries = {0};
    loop.scheduler.atEndOfTick(() -> {
      if (++tries[0] < 3) {
        throw new OutOfMemoryError();
      }
      loop.say("done");
    });
    loop.scheduler.atEndOfTick(() -> loop.say("other"));
    loop.run();
    assertEquals(List.of("other", "asked", "asked", "done"), loop.said);
    assertEquals(List.of(), loop.uncaught);
  }

  @Test
  void theEndOfATickThatNeverFitsIsReported() {
    Error failure = new OutOfMemoryError();
    loop.scheduler.atEndOfTick(() -> {
      throw failure;
    });
    assertThrows(AssertionError.class, loop::run);
    assertEquals(List.of(failure), loop.uncaught);
  }

  @Test
  void theLengthsOfTheTicksAreKept() {
    loop.start(job -> job.sleepUntil(3 * SECOND));
    loop.run();
    assertEquals(3, loop.scheduler.time().statistics().maximum());
    assertEquals(3 * SECOND, loop.scheduler.now());
  }

  /** The clock is read once. */
  @Test
  void inATickItIsAlwaysTheSameTime() {
    loop.start(job -> {
      loop.clock.now = SECOND;
      assertEquals(0, loop.scheduler.now());
      assertEquals(SECOND, loop.scheduler.measure());
      job.yieldNow();
      assertEquals(SECOND, loop.scheduler.now());
      // A clock that goes back does not.
      loop.clock.now = 0;
      job.yieldNow();
      assertEquals(SECOND, loop.scheduler.now());
    });
    loop.run();
    assertSame(loop.clock, loop.scheduler.clock());
  }

  // ------------------------------------------------------------------ who lets others run

  /** Who is alone looks for news now and then; the ticks that are left out count. */
  @Test
  void whoIsAloneHasATickOfItsOwnNowAndThen() {
    loop.start(job -> {
      long cycle = loop.scheduler.time().cycle();
      loop.scheduler.atEndOfTick(() -> loop.say("tick " + (loop.scheduler.time().cycle() - cycle)));
      for (int i = 1; i < 100; i++) {
        job.yield();
      }
      assertEquals(99, loop.scheduler.time().cycle() - cycle);
      assertEquals(List.of(), loop.said);
      job.yield();
      assertEquals(List.of("tick 99"), loop.said);
      assertEquals(100, loop.scheduler.time().cycle() - cycle);
      loop.scheduler.atEndOfTick(() -> loop.say("tick " + (loop.scheduler.time().cycle() - cycle)));
      for (int i = 1; i < 100; i++) {
        job.yield();
      }
      assertEquals(1, loop.said.size());
      job.yield();
      assertEquals(2, loop.said.size());
    });
    loop.run();
  }

  @Test
  void eachReasonToLetOthersRunIsOne() {
    loop.start(job -> {
      assertFalse(loop.scheduler.hasOthers());
      loop.start(other -> {});
      assertTrue(loop.scheduler.hasOthers());
      job.yieldNow();
      loop.scheduler.startAhead(null, loop.scheduler.rootScope(), "job", other -> {});
      assertTrue(loop.scheduler.hasOthers());
      job.yieldNow();
      loop.scheduler.startBehind(null, loop.scheduler.rootScope(), "job", other -> {});
      assertTrue(loop.scheduler.hasOthers());
      job.yieldNow();
      loop.post(() -> {});
      assertTrue(loop.scheduler.hasOthers());
      job.yieldNow();
      assertFalse(loop.scheduler.hasOthers());
      Job other = loop.start(next -> next.yieldNow());
      job.yieldNow();
      assertTrue(loop.scheduler.hasOthersFrom(0));
      assertFalse(loop.scheduler.hasOthersFrom(1));
      other.setPriority(1);
      assertTrue(loop.scheduler.hasOthersFrom(1));
      assertFalse(loop.scheduler.hasOthersFrom(2));
    });
    loop.run();
  }

  // ------------------------------------------------------------------ the end

  @Test
  void whenTheLoopIsStoppedTheJobsAreLeft() {
    loop.start(job -> {
      try {
        job.sleepUntil(SECOND);
      } finally {
        loop.say("left");
        job.yieldNow();
        loop.say("cleaned");
      }
    });
    loop.start(job -> {
      loop.scheduler.atEndOfTick(() -> loop.say("end of tick"));
      loop.scheduler.stop();
      loop.say("stopped");
    });
    loop.start(job -> loop.say("never"));
    loop.scheduler.startBehind(
        null, loop.scheduler.rootScope(), "job", job -> loop.say("never either"));
    assertFalse(loop.scheduler.isOver());
    assertEquals(List.of("stopped", "end of tick", "left", "cleaned"), loop.run());
    assertTrue(loop.scheduler.isOver());
    assertEquals(0, loop.scheduler.now());
  }

  @Test
  void whatIsToBeDoneAtTheEndOfTheLastTickIsDone() {
    loop.start(job -> {
      try {
        job.waitForWake();
      } finally {
        loop.scheduler.atEndOfTick(() -> loop.say("last"));
      }
    });
    assertEquals(List.of("last"), loop.run());
  }

  @Test
  void whoDoesNotEndIsGivenUp() {
    int[] turns = new int[1];
    Job job =
        loop.start(self -> {
          while (true) {
            try {
              self.yieldNow();
            } catch (TagStop stop) {
              turns[0]++;
              self.terminate();
            }
          }
        });
    loop.start(other -> loop.scheduler.stop());
    loop.run();
    assertEquals(1000, turns[0]);
    assertFalse(job.state() == JobState.ENDED);
  }

  @Test
  void theLastThingIsDoneEvenIfTheLoopFails() throws InterruptedException {
    RuntimeException failure = new IllegalStateException();
    loop.scheduler
        .time()
        .whenQuiet(() -> {
          throw failure;
        });
    loop.scheduler.startLoop(wrong -> loop.say("ended by " + wrong)).join();
    assertEquals(List.of(failure), loop.uncaught);
    assertEquals(List.of("ended by " + failure), loop.said);
  }

  @Test
  void withoutMemoryTheLoopGoesOn() {
    OutOfMemoryError failure = new OutOfMemoryError();
    loop.scheduler
        .time()
        .whenQuiet(() -> {
          loop.scheduler.stop();
          throw failure;
        });
    loop.start(job -> loop.say("job"));
    assertThrows(AssertionError.class, loop::run);
    assertEquals(List.of(failure), loop.uncaught);
    assertTrue(loop.scheduler.isOver());
  }

  /** Whoever tried on at once would keep the one from its turn who can free memory. */
  @Test
  void whateverGotNoMemoryWaitsUntilSomebodyIsAskedForSome() {
    OutOfMemoryError failure = new OutOfMemoryError();
    loop.scheduler.memory().setRelief(() -> loop.say("asked"));
    loop.start(job -> {
      loop.say("job");
      throw failure;
    });
    int[] tries = {0};
    int wanting =
        loop.scheduler
            .inbox()
            .register(message -> {
              loop.say("message");
              if (tries[0]++ == 0) {
                throw failure;
              }
            });
    loop.scheduler.inbox().post(new Message.InputEnded(wanting));
    loop.scheduler
        .time()
        .whenQuiet(() -> {
          loop.say("loop");
          loop.scheduler.stop();
          throw failure;
        });
    assertThrows(AssertionError.class, loop::run);
    assertEquals(
        List.of("message", "asked", "job", "asked", "message", "loop", "asked"), loop.said);
    assertEquals(List.of(failure, failure), loop.uncaught);
  }

  @Test
  void whereThereIsNoMemoryForWaitingEitherTheLoopGoesOn() {
    OutOfMemoryError failure = new OutOfMemoryError();
    loop.scheduler
        .memory()
        .setRelief(() -> {
          throw failure;
        });
    loop.start(job -> {
      throw failure;
    });
    assertThrows(AssertionError.class, loop::run);
    assertEquals(List.of(failure), loop.uncaught);
    assertTrue(loop.scheduler.isOver());
  }

  @Test
  void theKernelThreadKnowsItself() {
    AtomicBoolean elsewhere = new AtomicBoolean(true);
    loop.start(job -> {
      assertTrue(loop.scheduler.isKernelThread());
      Thread other =
          Thread.ofPlatform().start(() -> elsewhere.set(loop.scheduler.isKernelThread()));
      while (other.isAlive()) {
        Thread.onSpinWait();
      }
      loop.scheduler.atEndOfTick(() -> assertTrue(loop.scheduler.isKernelThread()));
    });
    assertFalse(loop.scheduler.isKernelThread());
    loop.run();
    assertFalse(elsewhere.get());
    assertFalse(loop.scheduler.isKernelThread());
  }
}
