package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.journal.StopReason;
import org.urbi.kernel.object.UrbiObject;

/** How a job lets others run, or does not, and how it is frozen (manual, "Job", "Tag"). */
class JobTurnsTest {
  private static final long SECOND = Loop.SECOND;

  private final Loop loop = new Loop();
  private final Scheduler scheduler = loop.scheduler;

  /** Another job says this, in its first turn. */
  private void other(String what) {
    loop.start(job -> loop.say(what));
  }

  // ------------------------------------------------------------------ how it lets others run

  @Test
  void whoIsAloneGoesOnAndTheTimePasses() {
    loop.start(self -> {
      long turn = scheduler.turn();
      long cycle = scheduler.time().cycle();
      self.yield();
      assertEquals(turn + 1, scheduler.turn());
      assertEquals(cycle + 1, scheduler.time().cycle());
    });
    loop.run();
  }

  @Test
  void whoIsNotAloneLetsTheOthersRun() {
    loop.start(self -> {
      other("first");
      self.yield();
      loop.say("self");
      other("second");
      self.yield();
    });
    assertEquals(List.of("first", "self", "second"), loop.run());
  }

  @Test
  void codeThatNobodyInterruptsGoesOn() {
    scheduler.setRefusals((problem, places) -> new IllegalArgumentException(problem.name()));
    loop.start(self -> {
      other("other");
      self.refuseInterruption();
      self.yield();
      self.yieldNow();
      loop.scheduler.interruptions().yieldWhileUnwinding(self);
      assertRefused(Problem.SLEEPS_UNINTERRUPTIBLE, () -> self.sleepUntil(SECOND));
      assertRefused(Problem.WAITS_UNINTERRUPTIBLE, self::waitForWake);
      TagState frozen = new TagState(null);
      frozen.freeze();
      TagScope scope = self.enter(frozen);
      assertTrue(self.isFrozen());
      assertRefused(Problem.WAITS_UNINTERRUPTIBLE, self::waitWhileFrozen);
      self.leave(scope);
      self.waitWhileFrozen();
      self.terminate();
      assertThrows(TagStop.class, self::yieldNow);
      self.terminate();
      assertThrows(TagStop.class, self::yield);
      scheduler.interruptions().requestOverdue(scheduler.turn(), StopReason.OVERDUE);
      assertThrows(TagStop.class, self::yield);
      loop.say("alone");
      self.endNonInterruptible(0);
      self.yield();
      loop.say("on");
    });
    assertEquals(List.of("alone", "other", "on"), loop.run());
  }

  private static void assertRefused(Problem problem, Runnable wait) {
    assertEquals(
        problem.name(), assertThrows(IllegalArgumentException.class, wait::run).getMessage());
  }

  @Test
  void onlyWhoHasThatPriorityInterrupts() {
    loop.start(self -> {
      other("low");
      self.yieldNow();
      self.setPriority(1);
      other("equal");
      self.yield();
      loop.say("high");
    });
    loop.start(self -> {
      for (int i = 0; i < 3; i++) {
        loop.say("turn " + i);
        self.yieldNow();
      }
    });
    assertEquals(List.of("low", "turn 0", "high", "equal", "turn 1", "turn 2"), loop.run());
  }

  @Test
  void thoseOfTheSamePriorityTakeTurns() {
    for (String name : List.of("a", "b")) {
      loop.start(
              self -> {
                loop.say(name + " 1");
                self.yield();
                loop.say(name + " 2");
              })
          .setPriority(1);
    }
    loop.start(self -> loop.say("low"));
    assertEquals(List.of("a 1", "b 1", "low", "a 2", "b 2"), loop.run());
  }

  @Test
  void whoBreathesLetsTheOthersRunAndGoesOnToEnd() {
    UrbiObject lobby = loop.object();
    Interruptions interruptions = scheduler.interruptions();
    scheduler.startDetached(
        lobby,
        scheduler.rootScope(),
        "job",
        self -> {
          loop.scheduler.interruptions().yieldWhileUnwinding(self);
          loop.say("alone");
          interruptions.request(lobby);
          assertThrows(TagStop.class, self::checkInterrupted);
          loop.start(next -> {
            next.checkInterrupted();
            loop.say("other");
          });
          loop.scheduler.interruptions().yieldWhileUnwinding(self);
          loop.say("on");
          loop.machine.now += SECOND;
          assertThrows(TagStop.class, self::checkInterrupted);
          // Even if there is nobody else the turn is another one.
          loop.scheduler.interruptions().yieldWhileUnwinding(self);
          assertThrows(TagStop.class, self::checkInterrupted);
        });
    assertEquals(List.of("alone", "other", "on"), loop.run());
  }

  /** What others read does not count for the condition that a job is evaluating. */
  @Test
  void eachJobHasWhatReadsForItself() {
    loop.start(self -> {
      loop.world.tracker = source -> {};
      var tracker = loop.world.tracker;
      loop.start(next -> assertNull(loop.world.tracker));
      self.yieldNow();
      assertSame(tracker, loop.world.tracker);
      loop.world.tracker = null;
    });
    loop.run();
  }

  // ------------------------------------------------------------------ frozen

  @Test
  void whoIsFrozenSleepsOnForWhatWasLeft() {
    TagState tag = new TagState(null);
    TagScope scope = scheduler.rootScope();
    loop.start(self -> {
      TagScope entered = self.enter(tag);
      self.sleepUntil(3 * SECOND);
      loop.say("slept until " + scheduler.now() / SECOND + " " + self.timeShift() / SECOND);
      self.leave(entered);
      assertSame(scope, self.scope());
    });
    loop.start(other -> {
      other.sleepUntil(SECOND);
      tag.freeze();
      tag.freeze();
      other.sleepUntil(11 * SECOND);
      tag.unfreeze();
      tag.unfreeze();
    });
    assertEquals(List.of("slept until 13 10"), loop.run());
  }

  @Test
  void whoCanRunIsHeldUntilNoTagAroundIsFrozen() {
    TagState one = new TagState(null);
    TagState two = new TagState(null);
    Job job =
        loop.start(self -> {
          self.enter(one);
          self.enter(two);
          one.freeze();
          two.freeze();
          self.waitWhileFrozen();
          loop.say("on at " + scheduler.now() / SECOND + " " + self.timeShift() / SECOND);
        });
    loop.start(other -> {
      other.sleepUntil(2 * SECOND);
      assertTrue(job.isFrozen());
      one.unfreeze();
      assertTrue(job.isFrozen());
      other.sleepUntil(5 * SECOND);
      two.unfreeze();
      assertFalse(job.isFrozen());
    });
    assertEquals(List.of("on at 5 5"), loop.run());
  }

  @Test
  void whoEntersFrozenCodeIsFrozenFromThenOn() {
    TagState tag = new TagState(null);
    tag.freeze();
    loop.start(self -> {
      self.sleepUntil(SECOND);
      self.enter(tag);
      self.waitWhileFrozen();
      loop.say("shift " + self.timeShift() / SECOND);
    });
    loop.start(other -> {
      other.sleepUntil(3 * SECOND);
      tag.unfreeze();
    });
    assertEquals(List.of("shift 2"), loop.run());
  }

  /** The time counts from when the first tag was frozen, whatever frozen code it enters then. */
  @Test
  void frozenCodeWithinFrozenCodeIsFrozenOnce() {
    TagState one = new TagState(null);
    TagState two = new TagState(null);
    two.freeze();
    loop.start(self -> {
      self.enter(one);
      one.freeze();
      loop.clock.now = SECOND;
      self.enter(two);
      self.waitWhileFrozen();
      loop.say("shift " + self.timeShift() / SECOND);
    });
    loop.start(other -> {
      other.sleepUntil(3 * SECOND);
      one.unfreeze();
      two.unfreeze();
    });
    assertEquals(List.of("shift 3"), loop.run());
  }

  @Test
  void aJobUnderAFrozenTagBeginsLater() {
    TagState tag = new TagState(null);
    TagScope scope = new TagScope(tag, scheduler.rootScope(), null);
    tag.freeze();
    Job job = loop.start(scope, self -> loop.say("begun " + self.timeShift() / SECOND));
    loop.start(other -> {
      other.sleepUntil(SECOND);
      tag.unfreeze();
    });
    assertTrue(job.isFrozen());
    assertEquals(List.of("begun 1"), loop.run());
  }

  @Test
  void whoIsHeldIsStoppedAllTheSame() {
    TagState frozen = new TagState(null);
    Job job =
        loop.start(self -> {
          self.enter(frozen);
          frozen.freeze();
          try {
            self.waitWhileFrozen();
          } finally {
            loop.say("left");
          }
        });
    loop.start(other -> {
      other.yieldNow();
      job.terminate();
      other.yieldNow();
      // It is gone: nothing is left to go on.
      frozen.unfreeze();
    });
    assertEquals(List.of("left"), loop.run());
  }

  /** Its time has stood still, also if the code under the tag never goes on. */
  @Test
  void whoIsStoppedWhileFrozenHasLostThatTime() {
    TagState tag = new TagState(null);
    loop.start(self -> {
      TagScope entered = self.enter(tag);
      try {
        self.sleepUntil(10 * SECOND);
      } catch (TagStop stop) {
        assertSame(entered, stop.scope());
      }
      self.leave(entered);
      loop.say("left at " + scheduler.now() / SECOND + " " + self.timeShift() / SECOND);
    });
    loop.start(other -> {
      other.sleepUntil(SECOND);
      tag.freeze();
      other.sleepUntil(5 * SECOND);
      tag.stop(scheduler, loop.object());
    });
    assertEquals(List.of("left at 5 4"), loop.run());
  }

  /** What a job starts lives in its parent's time. */
  @Test
  void timeShiftsAreInherited() {
    TagState tag = new TagState(null);
    loop.start(self -> {
      self.enter(tag);
      self.sleepUntil(SECOND);
      assertEquals(4 * SECOND, self.timeShift());
      assertEquals(4 * SECOND, loop.start(child -> {}).timeShift());
      assertEquals(
          4 * SECOND, scheduler.startAhead(null, self.scope(), "job", child -> {}).timeShift());
      assertEquals(4 * SECOND, new JobGroup(self).start(child -> {}).timeShift());
    });
    loop.start(other -> {
      tag.freeze();
      other.sleepUntil(4 * SECOND);
      tag.unfreeze();
    });
    loop.run();
    assertEquals(0, loop.start(child -> {}).timeShift());
    assertEquals(
        0, scheduler.startAhead(null, scheduler.rootScope(), "job", child -> {}).timeShift());
  }

  /** The time of a frozen job stands still, also if it was frozen before it began to sleep. */
  @Test
  void whoBeginsToSleepWhileFrozenSleepsOnceAndAsLong() {
    Job sleeper =
        loop.start(self -> {
          self.freezeAlone();
          self.sleepUntil(2 * SECOND);
          loop.say("slept until " + scheduler.now() / SECOND);
          self.waitForWake();
          loop.say("woken at " + scheduler.now() / SECOND);
        });
    loop.start(self -> {
      self.sleepUntil(SECOND);
      sleeper.unfreezeAlone();
      self.sleepUntil(10 * SECOND);
      sleeper.wake();
    });
    assertEquals(List.of("slept until 3", "woken at 10"), loop.run());
  }

  @Test
  void whoIsStoppedWhileItSleepsFrozenEnds() {
    Job sleeper =
        loop.start(self -> {
          self.freezeAlone();
          self.sleepUntil(2 * SECOND);
          loop.say("slept");
        });
    loop.start(self -> {
      self.sleepUntil(SECOND);
      sleeper.terminate();
      self.sleepUntil(5 * SECOND);
      loop.say(sleeper.state().text());
    });
    assertEquals(List.of("terminated"), loop.run());
  }
}
