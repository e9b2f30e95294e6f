package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.object.UrbiObject;

/**
 * Jobs whose client has left clean up, and what they begin then ends with them
 * (docs/robustness.md).
 */
class AbandonedScopeTest {
  private static final long SECOND = Loop.SECOND;

  private final Loop loop = new Loop();
  private final Scheduler scheduler = loop.scheduler;
  private final UrbiObject value = loop.object();
  private final TagState client = new TagState();
  private final TagScope connection = new TagScope(client, scheduler.rootScope(), null);

  /** Starts a job of the client, which says when it has ended. */
  private Job background(TagScope scope, String name) {
    return loop.start(
        scope,
        job -> {
          try {
            job.sleepUntil(100 * SECOND);
            loop.say(name + " has gone on");
          } finally {
            loop.say(name + " ends");
          }
        });
  }

  /** A job that is ended when its client leaves after a second, and does something then. */
  private void leaving(Job.Body cleaningUp) {
    loop.start(
        connection,
        job -> {
          try {
            job.sleepUntil(50 * SECOND);
          } finally {
            cleaningUp.run(job);
            loop.say("cleaned up");
          }
        });
    clientLeaves();
  }

  private void clientLeaves() {
    loop.start(other -> {
      other.sleepUntil(SECOND);
      client.abandon(scheduler, null);
    });
  }

  private void runToTheEnd() {
    loop.run();
    assertTrue(client.isIdle());
    assertEquals(List.of(), Loop.jobsUnder(scheduler.rootScope()));
  }

  @Test
  void aScopeIsAbandonedWithAllThatIsInIt() {
    TagScope inner = new TagScope(new TagState(), connection, null);
    assertFalse(inner.isAbandoned());
    connection.abandon();
    assertTrue(connection.isAbandoned());
    assertTrue(inner.isAbandoned());
    assertFalse(scheduler.rootScope().isAbandoned());
    assertFalse(new TagScope(new TagState(), scheduler.rootScope(), null).isAbandoned());
  }

  @Test
  void aShelterIsNotAbandonedUntilItsJobHasLeftIt() {
    connection.abandon();
    Job job = loop.idle(loop.lobby());
    Job other = loop.idle(loop.lobby());
    TagScope shelter = TagScope.shelter(connection, job);
    assertFalse(shelter.isAbandoned());
    assertFalse(new TagScope(client, shelter, null).isAbandoned());
    assertTrue(shelter.isShelterOf(job));
    assertFalse(shelter.isShelterOf(other));
    assertFalse(new TagScope(client, connection, job).isShelterOf(job));
    shelter.abandon();
    assertTrue(shelter.isAbandoned());
  }

  @Test
  void aTagIsUsedWhileSomethingIsUnderIt() {
    assertTrue(client.isUsed());
    connection.close();
    assertFalse(client.isUsed());
  }

  /** Perhaps nobody is left who would unfreeze it. */
  @Test
  void whatIsAbandonedIsNotFrozen() {
    TagState tag = new TagState();
    TagScope inner = new TagScope(tag, connection, null);
    tag.freeze();
    client.freeze();
    assertTrue(inner.isFrozen());
    assertTrue(inner.isSilent());
    connection.abandon();
    assertFalse(inner.isFrozen());
    assertFalse(inner.isSilent());
    TagScope shelter = TagScope.shelter(inner, loop.idle(loop.lobby()));
    TagScope below = new TagScope(new TagState(), shelter, null);
    assertFalse(shelter.isFrozen());
    assertFalse(below.isSilent());
    below.tag().freeze();
    assertTrue(below.isFrozen());
    assertTrue(below.isSilent());
    assertFalse(shelter.isFrozen());
    shelter.abandon();
    assertFalse(below.isFrozen());
  }

  @Test
  void aFrozenJobThatIsAbandonedCleansUp() {
    leaving(job -> {
      assertFalse(job.isFrozen());
      job.sleepUntil(3 * SECOND);
      client.unfreeze();
      client.freeze();
      job.sleepUntil(5 * SECOND);
      assertEquals(5 * SECOND, scheduler.now());
    });
    loop.start(other -> client.freeze());
    runToTheEnd();
    assertEquals(List.of("cleaned up"), loop.said);
  }

  @Test
  void soDoesOneThatWasFrozenAlone() {
    Job held =
        loop.start(
            connection,
            job -> {
              try {
                job.freezeAlone();
                job.waitWhileFrozen();
              } finally {
                job.sleepUntil(3 * SECOND);
                loop.say("cleaned up at " + scheduler.now() / SECOND);
              }
            });
    clientLeaves();
    runToTheEnd();
    assertEquals(List.of("cleaned up at 3"), loop.said);
    assertFalse(held.isFrozen());
  }

  /** What cleaning up freezes itself is frozen, and by others, too; but not for ever. */
  @Test
  void whatIsFrozenInAShelterGoesOnWhenThatIsAbandoned() {
    TagState tag = new TagState();
    leaving(job -> {
      loop.start(
          new TagScope(tag, job.scopeForNew(), null),
          begun -> {
            try {
              begun.sleepUntil(3 * SECOND);
              loop.say("has gone on");
            } finally {
              begun.sleepUntil(8 * SECOND);
              loop.say("child ends");
            }
          });
      job.sleepUntil(2 * SECOND);
      tag.freeze();
      job.sleepUntil(5 * SECOND);
    });
    loop.run();
    assertEquals(List.of("cleaned up", "child ends"), loop.said);
    assertEquals(8 * SECOND, loop.clock.now());
  }

  /** What takes too long to clean up is abandoned a second time. */
  @Test
  void whatHangsInItsShelterIsAbandonedAgain() {
    TagState tag = new TagState();
    tag.freeze();
    leaving(job -> {
      TagScope entered = job.enter(tag);
      try {
        job.waitWhileFrozen();
        loop.say("has gone on");
      } finally {
        assertFalse(job.isFrozen());
        background(job.scopeForNew(), "background");
        job.sleepUntil(6 * SECOND);
        loop.say("left at " + scheduler.now() / SECOND);
        job.leave(entered);
      }
    });
    loop.start(other -> {
      other.sleepUntil(4 * SECOND);
      client.abandon(scheduler, null);
    });
    runToTheEnd();
    assertEquals(List.of("left at 6", "background ends"), loop.said);
    assertFalse(tag.isUsed());
    connection.close();
    assertFalse(client.isUsed(), "a shelter is left");
  }

  @Test
  void whatIsNotAbandonedNeedsNoShelter() {
    loop.start(
        connection,
        job -> {
          assertSame(connection, job.scopeForNew());
          TagScope entered = job.enter(new TagState());
          assertSame(entered, job.scopeForNew());
          assertSame(connection, entered.parent());
          job.leave(entered);
          assertSame(connection, job.scope());
        });
    loop.run();
  }

  @Test
  void aStopByAProgramIsNotForGood() {
    loop.start(
        connection,
        job -> {
          try {
            job.sleepUntil(50 * SECOND);
          } finally {
            assertSame(connection, job.scopeForNew());
            background(job.scopeForNew(), "background");
          }
        });
    loop.start(other -> {
      other.sleepUntil(SECOND);
      client.stop(scheduler, value);
    });
    assertEquals(List.of("background has gone on", "background ends"), loop.run());
  }

  @Test
  void whatCleaningUpBeginsEndsWithItsJob() {
    leaving(job -> {
      assertNotSame(connection, job.scopeForNew());
      assertSame(job.scopeForNew(), job.scope());
      background(job.scopeForNew(), "background");
      job.sleepUntil(5 * SECOND);
    });
    runToTheEnd();
    assertEquals(List.of("cleaned up", "background ends"), loop.said);
    assertEquals(5 * SECOND, loop.clock.now());
  }

  /** The clauses of what was begun then find the same: it ends with them. */
  @Test
  void soDoesWhatThatBegins() {
    leaving(job -> {
      loop.start(
          job.scopeForNew(),
          begun -> {
            try {
              begun.sleepUntil(100 * SECOND);
            } finally {
              background(begun.scopeForNew(), "grandchild");
              begun.sleepUntil(6 * SECOND);
              loop.say("child ends");
            }
          });
      job.sleepUntil(2 * SECOND);
    });
    runToTheEnd();
    assertEquals(List.of("cleaned up", "child ends", "grandchild ends"), loop.said);
  }

  @Test
  void whatATagInsideHasBegunEndsWhenThatIsLeft() {
    leaving(job -> {
      TagScope entered = job.enter(new TagState());
      background(job.scopeForNew(), "inside");
      job.sleepUntil(3 * SECOND);
      job.leave(entered);
      loop.say("left");
      job.sleepUntil(4 * SECOND);
    });
    runToTheEnd();
    assertTrue(
        loop.said.containsAll(List.of("left", "inside ends", "cleaned up")), loop.said::toString);
    assertFalse(loop.said.contains("inside has gone on"));
  }

  /** A tag around, which a client's job has entered before, is left with the shelter below it. */
  @Test
  void leavingATagAroundEndsTheShelterInIt() {
    loop.start(
        connection,
        job -> {
          TagScope entered = job.enter(new TagState());
          try {
            job.sleepUntil(50 * SECOND);
          } finally {
            background(job.scopeForNew(), "below");
            assertNotSame(entered, job.scope());
            job.sleepUntil(3 * SECOND);
            job.leave(entered);
            loop.say("left");
            assertSame(connection, job.scope());
            job.sleepUntil(7 * SECOND);
            loop.say("later");
          }
        });
    clientLeaves();
    runToTheEnd();
    assertEquals(List.of("left", "below ends", "later"), loop.said);
  }

  @Test
  void aShelterInWhichNothingWasBegunIsGone() {
    TagState[] shelter = new TagState[1];
    leaving(job -> shelter[0] = job.scopeForNew().tag());
    runToTheEnd();
    assertFalse(shelter[0].isUsed());
    assertEquals(List.of("cleaned up"), loop.said);
  }
}
