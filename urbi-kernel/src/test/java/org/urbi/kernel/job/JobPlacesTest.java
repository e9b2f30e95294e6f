package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * A job is among all jobs, in its scope and in its group until it has ended, and among those that
 * can run when it can, whatever is done to it.
 */
class JobPlacesTest {
  private static final long SECOND = Loop.SECOND;

  private final Loop loop = new Loop();
  private final Scheduler scheduler = loop.scheduler;
  private final TagState tag = new TagState();
  private final TagScope scope = new TagScope(tag, scheduler.rootScope(), null);
  private final List<Job> all = new ArrayList<>();

  private Job under(Job.Body body) {
    return known(loop.start(scope, body));
  }

  private Job known(Job job) {
    all.add(job);
    return job;
  }

  /** Runs to the end; then no job may be anywhere. */
  private void runAll() {
    loop.run();
    for (Job job : all) {
      assertGone(job);
    }
    assertEquals(List.of(), scheduler.jobs());
    assertEquals(List.of(), Loop.jobsUnder(scheduler.rootScope()));
    assertTrue(tag.isIdle());
  }

  private static void assertGone(Job job) {
    assertEquals(JobState.ENDED, job.state());
    assertNull(job.turn.leave());
    assertNull(job.listed.leave());
    assertNull(job.scoped.leave());
    assertTrue(job.grouped == null || job.grouped.leave() == null);
  }

  @Test
  void whoEndsByItself() {
    under(self -> {});
    under(Job::yieldNow);
    under(self -> self.sleepUntil(SECOND));
    under(self -> {
      throw TagStop.WHOLE_JOB;
    });
    assertEquals(all, scheduler.jobs());
    assertEquals(all, Loop.jobsUnder(scope));
    runAll();
  }

  @Test
  void whoIsEndedBeforeItBegins() {
    Job.Body never = self -> loop.say("never");
    under(never).terminate();
    known(scheduler.startAhead(null, scope, "job", never)).terminate();
    known(scheduler.startBehind(null, scope, "job", never)).terminate();
    loop.start(parent -> {
      JobGroup group = new JobGroup(parent);
      known(group.start(never)).terminate();
      known(loop.start(never)).terminate();
      group.join();
      group.leave();
    });
    runAll();
    assertEquals(List.of(), loop.said);
  }

  /** Each of them has what it cleans up, which takes turns as well. */
  @Test
  void whoIsStoppedWhileItWaitsSleepsOrCanRun() {
    for (Job.Body waits : waits()) {
      under(self -> {
        try {
          waits.run(self);
        } finally {
          self.yieldNow();
          self.sleepUntil(SECOND);
        }
      });
    }
    loop.start(other -> {
      tag.stop(loop.scheduler, null);
      tag.stop(loop.scheduler, null);
    });
    runAll();
  }

  private static List<Job.Body> waits() {
    return List.of(Job::yieldNow, Job::waitForWake, self -> self.sleepUntil(SECOND));
  }

  @Test
  void whoIsEndedWhileItIsFrozen() {
    for (Job.Body waits : waits()) {
      under(waits);
    }
    Job late = under(self -> loop.say("never"));
    tag.freeze();
    Job stopped =
        loop.start(self -> {
          TagScope entered = self.enter(tag);
          try {
            self.waitWhileFrozen();
          } finally {
            self.leave(entered);
            loop.say("left");
          }
        });
    loop.start(other -> {
      other.yieldNow();
      late.terminate();
      other.yieldNow();
      assertGone(late);
      assertEquals(4, scheduler.jobs().size() - 1);
      tag.stop(loop.scheduler, null);
      other.yieldNow();
      all.forEach(JobPlacesTest::assertGone);
      assertGone(stopped);
      assertEquals(List.of(other), scheduler.jobs());
    });
    runAll();
    assertEquals(List.of("left"), loop.said);
  }

  @Test
  void whoWasFrozenGoesOn() {
    for (Job.Body waits : waits()) {
      under(waits);
    }
    tag.freeze();
    loop.start(other -> {
      other.sleepUntil(2 * SECOND);
      assertEquals(3, Loop.jobsUnder(scope).size());
      tag.unfreeze();
      other.yieldNow();
      other.yieldNow();
      all.get(1).wake();
    });
    runAll();
  }

  /** The lobby of a client that leaves: everything under its tag, and under tags within. */
  @Test
  void whoIsUnderTagsOfTags() {
    TagState inner = new TagState();
    for (int i = 0; i < 3; i++) {
      under(self -> {
        TagScope entered = self.enter(inner);
        try {
          JobGroup group = new JobGroup(self);
          known(group.start(Job::waitForWake));
          known(
              group.start(child -> {
                JobGroup nested = new JobGroup(child);
                known(nested.start(Job::waitForWake));
                known(nested.start(Job::waitForWake));
                try {
                  nested.join();
                } finally {
                  nested.leave();
                }
              }));
          try {
            group.join();
          } finally {
            group.leave();
          }
        } finally {
          self.leave(entered);
        }
      });
    }
    loop.start(other -> {
      other.sleepUntil(SECOND);
      assertEquals(15, Loop.jobsUnder(scope).size());
      assertEquals(16, scheduler.jobs().size());
      tag.stop(loop.scheduler, null);
    });
    runAll();
    assertTrue(inner.isIdle());
  }

  /** The others are ended while the first one leaves the list of the group. */
  @Test
  void whoEndsTogetherWithAGroup() {
    for (int failing = 0; failing < 5; failing++) {
      int failure = failing;
      under(parent -> {
        JobGroup group = new JobGroup(parent);
        for (int i = 0; i < 5; i++) {
          int number = i;
          known(
              group.start(child -> {
                if (number == failure) {
                  throw new IllegalStateException();
                }
                child.waitForWake();
              }));
        }
        try {
          group.join();
        } catch (ChildFailure report) {
          loop.say("failed");
        }
        group.leave();
      });
    }
    runAll();
    assertEquals(List.of("failed", "failed", "failed", "failed", "failed"), loop.said);
  }

  /** In one scope at a time: that of the innermost code, behind those that came there before. */
  @Test
  void whoEntersATagIsInItsScopeAlone() {
    Job first =
        under(self -> {
          self.yieldNow();
          TagScope inner = self.enter(new TagState());
          assertEquals(List.of(self), Loop.jobsUnder(inner));
          assertEquals(List.of(all.get(1), self), Loop.jobsUnder(scope));
          self.leave(inner);
          assertEquals(List.of(), Loop.jobsUnder(inner));
          assertEquals(List.of(all.get(1), self), Loop.jobsUnder(scope));
        });
    Job second = under(self -> self.sleepUntil(SECOND));
    assertEquals(List.of(first, second), Loop.jobsUnder(scope));
    runAll();
  }

  @Test
  void whoIsThereWhenTheKernelEnds() {
    under(Job::waitForWake);
    under(self -> self.sleepUntil(Long.MAX_VALUE));
    under(self -> {
      while (true) {
        self.yieldNow();
      }
    });
    loop.start(other -> {
      other.yieldNow();
      scheduler.stop();
    });
    runAll();
  }
}
