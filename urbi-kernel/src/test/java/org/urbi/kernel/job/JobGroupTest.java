package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.error.Problem;

/** The jobs that a job starts and waits for. */
class JobGroupTest {
  private static final long SECOND = Loop.SECOND;

  private final Loop loop = new Loop();

  @Test
  void theParentWaitsForAll() {
    loop.start(parent -> {
      JobGroup group = new JobGroup(parent);
      group.start(child -> child.sleepUntil(2 * SECOND));
      group.start(child -> loop.say("quick"));
      group.join();
      loop.say("joined at " + loop.scheduler.now() / SECOND);
      group.join();
      group.leave();
    });
    assertEquals(List.of("quick", "joined at 2"), loop.run());
  }

  @Test
  void whatOneIsLeftByLeavesTheParentAndEndsTheOthers() {
    RuntimeException failure = new IllegalArgumentException();
    loop.start(parent -> {
      JobGroup group = new JobGroup(parent);
      group
          .start(child -> child.sleepUntil(2 * SECOND))
          .onEnd(() -> loop.say("ended at " + loop.scheduler.now() / SECOND));
      group.start(child -> {
        child.sleepUntil(SECOND);
        throw failure;
      });
      ChildFailure report = assertThrows(ChildFailure.class, group::join);
      assertSame(failure, group.translate(report));
      assertSame(failure, assertThrows(IllegalArgumentException.class, group::join));
      RuntimeException own = new IllegalStateException();
      assertSame(own, group.translate(own));
      assertSame(report, new JobGroup(parent).translate(report));
      group.leave();
    });
    assertEquals(List.of("ended at 1"), loop.run());
  }

  @Test
  void othersHaveTheirTurnsWhileVeryManyAreStarted() {
    loop.start(parent -> {
      JobGroup group = new JobGroup(parent);
      for (int i = 0; i < 25_000; i++) {
        group.start(child -> {});
      }
      loop.say("all");
      group.join();
      group.leave();
    });
    loop.start(other -> {
      loop.say("one");
      other.yield();
      loop.say("two");
      other.yield();
      loop.say("three");
    });
    assertEquals(List.of("one", "two", "all", "three"), loop.run());
  }

  @Test
  void noMoreAreStartedWhenOneHasFailed() {
    RuntimeException failure = new IllegalArgumentException();
    loop.start(parent -> {
      JobGroup group = new JobGroup(parent);
      group.start(child -> {
        throw failure;
      });
      for (int i = 1; i < 10_000; i++) {
        group.start(child -> {});
      }
      assertSame(
          failure,
          assertThrows(IllegalArgumentException.class, () -> group.start(child -> loop.say("no"))));
      group.leave();
    });
    assertEquals(List.of(), loop.run());
  }

  /** The first failure counts, even if the others fail while they end. */
  @Test
  void ofManyFailuresTheFirstCounts() {
    RuntimeException failure = new IllegalArgumentException();
    loop.start(parent -> {
      JobGroup group = new JobGroup(parent);
      group.start(child -> {
        try {
          child.waitForWake();
        } finally {
          throwLater();
        }
      });
      group.start(child -> {
        throw failure;
      });
      try {
        parent.sleepUntil(SECOND);
      } catch (ChildFailure report) {
        assertSame(failure, group.translate(report));
        loop.say("reported");
      }
      parent.yieldNow();
      parent.checkInjected();
      assertThrows(IllegalArgumentException.class, group::join);
      group.leave();
    });
    assertEquals(List.of("reported"), loop.run());
  }

  private static void throwLater() {
    throw new IllegalStateException();
  }

  @Test
  void errorsAreThrownAsTheyAre() {
    Error error = new StackOverflowError();
    loop.start(parent -> {
      JobGroup group = new JobGroup(parent);
      group.start(child -> {
        throw error;
      });
      ChildFailure report = assertThrows(ChildFailure.class, group::join);
      assertSame(error, assertThrows(StackOverflowError.class, () -> group.translate(report)));
      group.leave();
    });
    loop.run();
  }

  @Test
  void whoLeavesTheGroupEndsWhatIsLeftAndHearsNoMore() {
    loop.start(parent -> {
      JobGroup group = new JobGroup(parent);
      group
          .start(child -> {
            try {
              child.sleepUntil(SECOND);
            } finally {
              throwLater();
            }
          })
          .onEnd(() -> loop.say("ended at " + loop.scheduler.now()));
      parent.yieldNow();
      group.leave();
      parent.yieldNow();
      parent.checkInjected();
      loop.say("on");
    });
    assertEquals(List.of("ended at 0", "on"), loop.run());
  }

  @Test
  void aReportThatComesTooLateIsForgotten() {
    loop.start(parent -> {
      JobGroup group = new JobGroup(parent);
      JobGroup other = new JobGroup(parent);
      parent.inject(new ChildFailure(group, new IllegalStateException()));
      other.leave();
      assertThrows(ChildFailure.class, parent::checkInjected);
      parent.inject(new ChildFailure(group, new IllegalStateException()));
      group.leave();
      parent.checkInjected();
    });
    loop.run();
  }

  @Test
  void codeThatNobodyInterruptsDependsOnNobody() {
    loop.scheduler.setRefusals((problem, places) -> new IllegalArgumentException(problem.name()));
    loop.start(parent -> {
      parent.refuseInterruption();
      JobGroup group = new JobGroup(parent);
      group.join();
      group.start(child -> {});
      assertEquals(
          Problem.DEPENDS_UNINTERRUPTIBLE.name(),
          assertThrows(IllegalArgumentException.class, group::join).getMessage());
      group.leave();
    });
    loop.run();
  }

  /** Who waits for something else is not woken by the end of a child, while others go on. */
  @Test
  void onlyTheLastOneWakesTheParent() {
    loop.start(parent -> {
      JobGroup group = new JobGroup(parent);
      group.start(child -> {});
      group.start(child -> child.sleepUntil(SECOND));
      parent.waitForWake();
      loop.say("woken at " + loop.scheduler.now() / SECOND);
      group.leave();
    });
    assertEquals(List.of("woken at 1"), loop.run());
  }
}
