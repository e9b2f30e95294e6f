package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import org.urbi.kernel.trust.Role;
import org.urbi.kernel.trust.RoleHolder;

/** What a job is, and how it is left (manual, "Job"). */
class JobLifeTest {
  private static final long SECOND = Loop.SECOND;

  private final Loop loop = new Loop();
  private final Scheduler scheduler = loop.scheduler;

  /** A lobby whose code may do little. */
  private static final class Guest extends UrbiObject implements RoleHolder {
    Guest(World world) {
      super(world.orphanShape());
    }

    @Override
    public Role role() {
      return Role.OBSERVER;
    }
  }

  // ------------------------------------------------------------------ what it is

  @Test
  void jobsHaveNumbersAndNames() {
    long before = scheduler.nextNumber();
    Job job = loop.idle(null);
    assertEquals(before + 1, job.number());
    assertEquals("job_" + (before + 1), job.name());
    assertSame(scheduler, job.scheduler());
  }

  @Test
  void aJobMayDoWhatItsLobbyMay() {
    Guest guest = new Guest(loop.world);
    UrbiObject owner = loop.object();
    Job job = loop.idle(guest);
    assertSame(guest, job.lobby());
    assertEquals(Role.OBSERVER, job.identity().role());
    assertFalse(job.isOwner());
    job.identity().become(owner);
    assertSame(owner, job.lobby());
    assertEquals(Role.OWNER, job.identity().role());
    assertTrue(job.isOwner());
  }

  @Test
  void somethingIsDoneForWhoMayDoSomethingElse() {
    Guest guest = new Guest(loop.world);
    UrbiObject owner = loop.object();
    Job job = loop.idle(owner);
    assertSame(guest, job.identity().doFor(guest, job::lobby));
    assertEquals(Role.OBSERVER, job.identity().doFor(guest, job.identity()::role));
    assertSame(owner, job.lobby());
    // Another lobby that may do everything makes no difference.
    assertSame(owner, job.identity().doFor(loop.object(), job::lobby));
    job.identity().become(guest);
    assertSame(owner, job.identity().doFor(owner, job::lobby));
    assertSame(guest, job.identity().doFor(guest, job::lobby));
    Guest another = new Guest(loop.world);
    assertSame(another, job.identity().doFor(another, job::lobby));
    assertThrows(
        IllegalStateException.class,
        () ->
            job.identity()
                .doFor(
                    owner,
                    () -> {
                      throw new IllegalStateException();
                    }));
    assertSame(guest, job.lobby());
    assertFalse(job.isOwner());
  }

  @Test
  void aJobRestsWhenItSaysSo() {
    Job job = loop.idle(null);
    assertFalse(job.isDaemon());
    job.setDaemon(true);
    assertTrue(job.isDaemon());
  }

  @Test
  void messagesWithinMessagesAreCounted() {
    Job job = loop.idle(null);
    assertTrue(job.beginSend(2));
    assertTrue(job.beginSend(2));
    assertFalse(job.beginSend(2));
    assertFalse(job.beginSend(2));
    job.endSend();
    assertTrue(job.beginSend(2));
    assertFalse(job.beginSend(2));
  }

  @Test
  void scopesThatNobodyInterruptsAreCounted() {
    Job job = loop.idle(null);
    job.refuseInterruption();
    job.refuseInterruption();
    assertEquals(2, job.nonInterruptible());
    job.endNonInterruptible(1);
    assertEquals(1, job.nonInterruptible());
    job.endNonInterruptible(4);
    assertEquals(1, job.nonInterruptible());
  }

  @Test
  void whatAJobStartsHasItsPriorityAndTellsItsObserver() {
    JobObserver ofChildren = new Recorder("child");
    Recorder recorder =
        new Recorder("parent") {
          @Override
          public JobObserver forChild() {
            return ofChildren;
          }
        };
    loop.start(job -> {
      job.setPriority(3);
      Job plain = loop.start(child -> {});
      assertNull(plain.observer());
      assertEquals(3, plain.priority());
      job.observe(recorder);
      assertSame(recorder, job.observer());
      assertSame(ofChildren, loop.start(child -> {}).observer());
      job.yieldNow();
      loop.say("on");
    });
    assertEquals(0, loop.idle(null).priority());
    assertEquals(List.of("parent out", "parent in", "on"), loop.run());
  }

  /** Says when the job lets others run. */
  private class Recorder implements JobObserver {
    private final String name;

    Recorder(String name) {
      this.name = name;
    }

    @Override
    public void switchedOut() {
      loop.say(name + " out");
    }

    @Override
    public void switchedIn() {
      loop.say(name + " in");
    }

    @Override
    public JobObserver forChild() {
      return null;
    }
  }

  // ------------------------------------------------------------------ how it ends

  @Test
  void aJobGoesThroughItsStates() {
    Job job =
        loop.start(self -> {
          assertEquals(JobState.RUNNING, self.state());
          self.waitForWake();
          assertEquals(JobState.RUNNING, self.state());
          self.sleepUntil(SECOND);
          self.yieldNow();
        });
    loop.start(other -> {
      assertEquals(JobState.WAITING, job.state());
      assertEquals("waiting", job.state().text());
      job.wake();
      assertEquals(JobState.RUNNABLE, job.state());
      // That is no news for who does not wait.
      job.wake();
      other.yieldNow();
      assertEquals(JobState.SLEEPING, job.state());
      assertTrue(scheduler.jobs().contains(job));
      job.wake();
      other.sleepUntil(2 * SECOND);
      assertEquals(JobState.ENDED, job.state());
      assertFalse(scheduler.jobs().contains(job));
    });
    assertEquals(JobState.RUNNABLE, job.state());
    loop.run();
    assertEquals(2 * SECOND, scheduler.now());
  }

  @Test
  void whoWaitsForTheEndIsTold() {
    Job job = loop.start(self -> loop.say("job"));
    job.onEnd(() -> loop.say("one"));
    job.onEnd(() -> loop.say("two"));
    assertEquals(List.of("job", "one", "two"), loop.run());
    job.onEnd(() -> loop.say("late"));
    assertEquals("late", loop.said.getLast());
  }

  @Test
  void whoeverNoLongerWaitsForTheEndIsForgotten() {
    Job job = loop.start(self -> loop.say("job"));
    Runnable impatient = () -> loop.say("never");
    job.forgetOnEnd(impatient);
    job.onEnd(() -> loop.say("one"));
    job.onEnd(impatient);
    job.onEnd(() -> loop.say("two"));
    job.forgetOnEnd(impatient);
    assertEquals(List.of("job", "one", "two"), loop.run());
    job.forgetOnEnd(impatient);
  }

  @Test
  void whatNobodyCatchesIsReportedWithTheJob() {
    RuntimeException failure = new IllegalStateException("mine");
    RuntimeException later = new IllegalStateException("listener");
    long[] turn = new long[2];
    Job job =
        loop.start(self -> {
          turn[0] = scheduler.turn();
          throw failure;
        });
    job.onEnd(() -> {
      turn[1] = scheduler.turn();
      throw later;
    });
    job.onEnd(() -> loop.say("told"));
    assertThrows(AssertionError.class, loop::run);
    assertEquals(List.of(failure, later), loop.uncaught);
    assertEquals(List.of("told"), loop.said);
    assertEquals(turn[0] + 1, turn[1], "what ends has a turn of its own");
  }

  /** An exception tells of itself by code of the user, which may be ended. */
  @Test
  void whoWaitsForTheEndIsToldAlsoWhenTheReportIsStopped() {
    Loop stopping =
        new Loop((job, failure) -> {
          throw TagStop.interruption();
        });
    Job job =
        stopping.start(self -> {
          throw new IllegalStateException("mine");
        });
    job.onEnd(() -> stopping.say("told"));
    assertEquals(List.of("told"), stopping.run());
  }

  @Test
  void aJobThatIsEndedBeforeItBeginsDoesNothing() {
    Job job = loop.start(self -> loop.say("never"));
    job.onEnd(() -> loop.say("ended"));
    job.terminate();
    assertEquals(List.of("ended"), loop.run());
    job.terminate();
    job.resume();
    assertEquals(JobState.ENDED, job.state());
  }

  /** Between the moment when it is woken and its turn. */
  @Test
  void aSleeperIsStoppedOnce() {
    Job job =
        loop.start(self -> {
          try {
            self.sleepUntil(SECOND);
          } finally {
            loop.say("left at " + scheduler.now());
            self.sleepUntil(3 * SECOND);
            loop.say("cleaned at " + scheduler.now());
          }
        });
    loop.start(other -> job.terminate());
    assertEquals(List.of("left at 0", "cleaned at 3000000000"), loop.run());
  }

  @Test
  void whoWaitsIsStopped() {
    Job job =
        loop.start(self -> {
          try {
            self.waitForWake();
          } finally {
            loop.say("left");
          }
        });
    loop.start(other -> {
      job.terminate();
      assertEquals(JobState.RUNNABLE, job.state());
    });
    assertEquals(List.of("left"), loop.run());
  }

  /** Who is to have its turn anyway has no other one by being stopped. */
  @Test
  void whoIsStoppedInItsQueueHasOneTurn() {
    Job job =
        loop.start(self -> {
          try {
            self.yieldNow();
          } finally {
            self.sleepUntil(SECOND);
            loop.say("cleaned at " + scheduler.now() / SECOND);
          }
        });
    loop.start(other -> job.terminate());
    assertEquals(List.of("cleaned at 1"), loop.run());
  }

  @Test
  void theRunningJobIsLeftAtTheNextLook() {
    loop.start(self -> {
      self.terminate();
      loop.say("still there");
      self.yield();
      loop.say("never");
    });
    assertEquals(List.of("still there"), loop.run());
  }

  /** Each time the outer scope is what the job has to leave, whichever was stopped first. */
  @Test
  void ofTwoStopsTheOuterOneWins() {
    Object[] stopped = new Object[4];
    TagState outerTag = new TagState(null);
    TagState innerTag = new TagState(null);
    for (int i = 0; i < 4; i++) {
      int order = i;
      loop.start(self -> {
        TagScope outer = self.enter(outerTag);
        TagScope inner = self.enter(innerTag);
        TagStop outerStop = new TagStop(outer, null);
        TagStop innerStop = new TagStop(inner, null);
        switch (order) {
          case 0 -> injectBoth(self, outerStop, innerStop);
          case 1 -> injectBoth(self, innerStop, outerStop);
          case 2 -> injectBoth(self, new TagStop(null, null), innerStop);
          default -> injectBoth(self, innerStop, new TagStop(null, null));
        }
        TagStop thrown = assertThrows(TagStop.class, self::checkInjected);
        stopped[order] = thrown.scope() == outer ? "outer" : thrown.scope() == null ? "all" : "";
        self.checkInjected();
        self.leave(inner);
        self.leave(outer);
      });
    }
    loop.run();
    assertEquals(List.of("outer", "outer", "all", "all"), List.of(stopped));
  }

  private static void injectBoth(Job job, ControlFlowException first, ControlFlowException second) {
    job.inject(first);
    job.inject(second);
  }

  @Test
  void ofTwoStopsOfTheSameScopeTheFirstOneWins() {
    UrbiObject first = loop.object();
    loop.start(self -> {
      TagScope scope = self.enter(new TagState(null));
      injectBoth(self, new TagStop(scope, first), new TagStop(scope, null));
      assertSame(first, assertThrows(TagStop.class, self::checkInjected).value());
      self.leave(scope);
    });
    loop.run();
  }

  @Test
  void aStopIsMoreThanTheReportOfAChildAndNotTheOtherWayRound() {
    loop.start(self -> {
      TagScope scope = self.enter(new TagState(null));
      ChildFailure report = reportTo(self);
      injectBoth(self, report, new TagStop(scope, null));
      assertThrows(TagStop.class, self::checkInjected);
      injectBoth(self, new TagStop(scope, null), report);
      assertThrows(TagStop.class, self::checkInjected);
      injectBoth(self, report, reportTo(self));
      assertSame(report, assertThrows(ChildFailure.class, self::checkInjected));
      self.leave(scope);
    });
    loop.run();
  }

  private static ChildFailure reportTo(Job parent) {
    return new ChildFailure(new JobGroup(parent), new IllegalStateException());
  }

  @Test
  void aStopOfCodeThatWasLeftIsForgotten() {
    TagState tag = new TagState(null);
    loop.start(self -> {
      TagScope scope = self.enter(tag);
      tag.stop(loop.scheduler, null);
      self.leave(scope);
      self.checkInjected();
      TagScope around = self.enter(tag);
      TagScope within = self.enter(new TagState(null));
      tag.stop(loop.scheduler, null);
      self.leave(within);
      assertThrows(TagStop.class, self::checkInjected);
      self.leave(around);
      assertEquals(0, tag.scopes.size());
    });
    loop.run();
  }

  // ------------------------------------------------------------------ in Java

  @Test
  void codeOfAComponentIsKnownByItsFunction() {
    loop.start(self -> {
      assertNull(self.componentCode().function());
      String none = self.componentCode().enter("A.outer");
      assertEquals("A.outer", self.componentCode().function());
      String outer = self.componentCode().enter("B.inner");
      assertEquals("B.inner", self.componentCode().function());
      self.componentCode().leave(outer);
      assertEquals("A.outer", self.componentCode().function());
      self.componentCode().leave(none);
      assertNull(self.componentCode().function());
    });
    loop.run();
  }

  /** Only the outermost one: urbiscript around the inner one could catch it. */
  @Test
  void whoLeavesTheOutermostComponentIsLeftByTheInterruption() {
    UrbiObject lobby = loop.object();
    scheduler.startDetached(
        lobby,
        scheduler.rootScope(),
        "job",
        self -> {
          String none = self.componentCode().enter("A.outer");
          String outer = self.componentCode().enter("B.inner");
          scheduler.interruptions().request(lobby);
          self.componentCode().leave(outer);
          assertThrows(TagStop.class, () -> self.componentCode().leave(none));
          assertNull(self.componentCode().function());
          loop.say("left");
        });
    assertEquals(List.of("left"), loop.run());
  }

  @Test
  void aComponentIsInterruptedInItsTurnAlone() {
    loop.start(self -> {
      self.componentCode().interrupt(scheduler.turn());
      assertFalse(Thread.currentThread().isInterrupted());
      self.componentCode().enter("A.f");
      self.componentCode().interrupt(scheduler.turn() - 1);
      assertFalse(Thread.currentThread().isInterrupted());
      self.componentCode().interrupt(scheduler.turn());
      assertTrue(Thread.currentThread().isInterrupted());
      scheduler.interruptions().request(loop.object());
      self.componentCode().leave(null);
      assertFalse(Thread.currentThread().isInterrupted());
      // What the component has interrupted itself is its own concern.
      Thread.currentThread().interrupt();
      self.componentCode().enter("A.f");
      self.componentCode().leave(null);
      assertTrue(Thread.interrupted());
      loop.say("done");
    });
    assertEquals(List.of("done"), loop.run());
  }
}
