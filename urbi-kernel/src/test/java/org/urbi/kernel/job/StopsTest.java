package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.object.UrbiObject;

/** The stop of a tag with very much under it, between the pieces of which others run. */
class StopsTest {
  /** More than four pieces. */
  private static final int MANY = 2200;

  private final Loop loop = new Loop(ManualClock.real());
  private final UrbiObject value = loop.object();
  private final TagState tag = new TagState(loop.object());
  private final TagScope scope = TagScope.branch(loop.scheduler, tag, loop.scheduler.rootScope());
  private final List<Integer> ends = new ArrayList<>();
  private int turns;
  private boolean stopped;

  /** Has a turn in each round, until there is no other job. */
  private void judge(Job job) {
    while (loop.scheduler.jobs().size() > 1) {
      turns++;
      job.yieldNow();
    }
  }

  private Job sleeper(int number) {
    return loop.start(
        scope,
        job -> {
          try {
            job.sleepUntil(Loop.SECOND);
          } finally {
            ends.add(number);
          }
        });
  }

  private void stop() {
    stopped = true;
    tag.stop(loop.scheduler, value);
  }

  @Test
  void othersRunInBetweenAndTheOrderRemains() {
    IntStream.range(0, MANY).forEach(this::sleeper);
    loop.start(this::judge);
    loop.start(job -> {
      stop();
      int before = turns;
      while (ends.size() < MANY) {
        job.yieldNow();
      }
      loop.say(turns - before > MANY / 500 ? "in pieces" : turns - before + " turns");
    });
    assertEquals(List.of("in pieces"), loop.run());
    assertEquals(IntStream.range(0, MANY).boxed().toList(), ends);
    assertTrue(loop.scheduler.stops().isEmpty());
  }

  @Test
  void theEndOfManyThingsIsMadeInPieces() {
    loop.start(job -> {
      List<Integer> first = IntStream.range(0, MANY / 2).boxed().toList();
      EndInPieces.begin(
          loop.scheduler,
          first,
          each -> {
            ends.add(each);
            return each < MANY / 2 ? List.of(each + MANY / 2) : List.of();
          });
      loop.say("first " + ends.size());
      int rounds = 0;
      while (ends.size() < MANY) {
        job.yieldNow();
        rounds++;
      }
      loop.say("rounds " + rounds);
    });
    assertEquals(List.of("first 500", "rounds 4"), loop.run());
    assertEquals(IntStream.range(0, MANY).boxed().toList(), ends);
  }

  @Test
  void inSimulatedTimeNobodyWaits() {
    Loop simulated = new Loop();
    TagScope there = TagScope.branch(simulated.scheduler, tag, simulated.scheduler.rootScope());
    for (int i = 0; i < MANY; i++) {
      simulated.start(there, job -> job.sleepUntil(Loop.SECOND));
    }
    simulated.start(job -> {
      tag.stop(simulated.scheduler, value);
      assertTrue(simulated.scheduler.stops().isEmpty());
      simulated.say("at once");
    });
    assertEquals(List.of("at once"), simulated.run());
  }

  @Test
  void theRestOfAGroupEndsInPiecesToo() {
    loop.start(this::judge);
    loop.start(parent -> {
      JobGroup group = new JobGroup(parent);
      for (int i = 0; i < MANY; i++) {
        int number = i;
        group.start(job -> {
          try {
            job.sleepUntil(Loop.SECOND);
          } finally {
            ends.add(number);
          }
        });
      }
      parent.yieldNow();
      parent.yieldNow();
      group.leave();
      int before = turns;
      while (ends.size() < MANY) {
        parent.yieldNow();
      }
      loop.say(turns - before > MANY / 500 ? "in pieces" : turns - before + " turns");
    });
    assertEquals(List.of("in pieces"), loop.run());
    assertEquals(IntStream.range(0, MANY).boxed().toList(), ends);
  }

  /** Jobs that could run have their turns before a piece comes to them. */
  @Test
  void noneExecutesAnythingButItsEnd() {
    for (int i = 0; i < MANY; i++) {
      loop.start(
          scope,
          job -> {
            while (true) {
              job.yieldNow();
              assertFalse(stopped);
            }
          });
    }
    loop.start(job -> {
      job.yieldNow();
      stop();
    });
    loop.run();
    assertTrue(tag.isIdle());
  }

  @Test
  void anEndIsNotEndedAgain() {
    for (int i = 0; i < MANY; i++) {
      int number = i;
      loop.start(
          scope,
          job -> {
            try {
              job.sleepUntil(Loop.SECOND);
            } catch (TagStop stop) {
              assertSame(scope, stop.scope());
              assertSame(value, stop.value());
              job.yieldNow();
              job.yieldNow();
              ends.add(number);
            }
          });
    }
    loop.start(job -> stop());
    loop.run();
    assertEquals(MANY, ends.size());
  }

  @Test
  void whoStopsItselfEndsAtOnce() {
    for (int i = 0; i < MANY; i++) {
      sleeper(i);
    }
    loop.start(
        scope,
        job -> {
          stop();
          try {
            job.checkInjected();
          } finally {
            job.yieldNow();
            loop.say("ended once");
          }
          loop.say("went on");
        });
    assertEquals(List.of("ended once"), loop.run());
  }

  @Test
  void whatBeginsLaterIsNotStopped() {
    for (int i = 0; i < MANY; i++) {
      sleeper(i);
    }
    loop.start(job -> {
      stop();
      loop.start(
          scope,
          other -> {
            other.yieldNow();
            loop.say("a new job");
          });
      TagScope again = job.enter(tag);
      assertFalse(again.isSilent());
      while (!loop.scheduler.stops().isEmpty()) {
        job.yieldNow();
      }
      job.leave(again);
      loop.say("new code");
    });
    assertEquals(List.of("a new job", "new code"), loop.run());
  }

  @Test
  void handlersAreSilentUntilTheirTurn() {
    TagScope within = TagScope.branch(loop.scheduler, new TagState(), scope);
    List<Integer> told = new ArrayList<>();
    for (int i = 0; i < MANY; i++) {
      int number = i;
      (i < 10 ? scope : within)
          .add(
              (TagScope.Attachment)
                  by -> {
                    assertSame(scope, by);
                    told.add(number);
                    if (number == 1000) {
                      throw new IllegalStateException("a handler that fails");
                    }
                  });
    }
    loop.start(job -> {
      stop();
      assertTrue(told.size() < MANY / 2);
      assertTrue(within.isSilent());
      assertTrue(within.isStopping());
      assertFalse(within.isFrozen());
      while (!loop.scheduler.stops().isEmpty()) {
        job.yieldNow();
      }
      assertFalse(within.isSilent());
      assertFalse(within.isStopping());
    });
    try {
      loop.run();
    } catch (AssertionError e) {
      assertEquals("a handler that fails", loop.uncaught.removeFirst().getMessage());
      assertEquals(List.of(), loop.uncaught);
    }
    assertEquals(IntStream.range(0, MANY).boxed().toList(), told);
  }

  @Test
  void ofTwoStopsTheOuterOneWins() {
    TagState inner = new TagState(loop.object());
    List<TagScope> by = new ArrayList<>();
    for (int i = 0; i < MANY; i++) {
      loop.start(
          scope,
          job -> {
            TagScope entered = job.enter(inner);
            try {
              job.sleepUntil(Loop.SECOND);
            } catch (TagStop stop) {
              by.add(stop.scope());
              throw stop;
            } finally {
              job.leave(entered);
            }
          });
    }
    loop.start(job -> {
      job.yieldNow();
      inner.stop(loop.scheduler, value);
      stop();
    });
    loop.run();
    assertEquals(MANY, by.size());
    assertEquals(MANY, by.stream().filter(each -> each == scope).count());
  }
}
