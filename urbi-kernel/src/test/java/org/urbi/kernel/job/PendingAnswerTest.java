package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Outcome;

/** What a job waits for, and another thread brings about. */
class PendingAnswerTest {
  private final Loop loop = new Loop();
  private final Outcome outcome = Outcome.value("there");

  @Test
  void theJobWaitsUntilItIsThereWhileTheOthersGoOn() {
    loop.start(job -> {
      PendingAnswer answer = new PendingAnswer(job, Wait.FILE);
      assertTrue(loop.scheduler.pace().isReal());
      loop.start(other -> {
        loop.say("other");
        answer.post(outcome);
      });
      assertSame(outcome, answer.await());
      loop.say("answered");
      assertFalse(loop.scheduler.pace().isReal());
    });
    assertEquals(List.of("other", "answered"), loop.run());
  }

  @Test
  void itComesFromAnotherThread() {
    loop.start(job -> {
      PendingAnswer answer = new PendingAnswer(job, Wait.FILE);
      Thread.ofPlatform().start(() -> answer.post(outcome));
      assertSame(outcome, answer.await());
      loop.say("answered");
    });
    assertEquals(List.of("answered"), loop.run());
  }

  @Test
  void whatIsThereIsNotWaitedFor() {
    loop.start(job -> {
      PendingAnswer answer = new PendingAnswer(job, Wait.FILE);
      answer.arrived(outcome);
      long turn = loop.scheduler.turn();
      assertSame(outcome, answer.await());
      assertEquals(turn, loop.scheduler.turn());
    });
    loop.run();
  }

  /** It is for nobody else than who waited for it: its number is gone. */
  @Test
  void itComesOnce() {
    loop.start(job -> {
      PendingAnswer answer = new PendingAnswer(job, Wait.FILE);
      answer.post(outcome);
      answer.post(Outcome.value("again"));
      assertSame(outcome, answer.await());
      job.yieldNow();
      assertSame(outcome, answer.await());
      // Something real that has ended twice would not be real when it begins.
      loop.scheduler.pace().begin();
      assertTrue(loop.scheduler.pace().isReal());
      loop.scheduler.pace().end();
    });
    loop.run();
  }

  @Test
  void whoDoesNotWaitAnyMoreIsNotWoken() {
    loop.start(job -> {
      PendingAnswer answer = new PendingAnswer(job, Wait.FILE);
      answer.abandon();
      loop.start(other -> {
        answer.take(new Message.Answer(0, outcome));
        other.yieldNow();
        loop.say("before");
        job.wake();
      });
      job.waitForWake();
      loop.say("woken");
    });
    assertEquals(List.of("before", "woken"), loop.run());
  }

  @Test
  void whoIsStoppedWhileItWaitsIsNotWokenLater() {
    loop.start(job -> {
      PendingAnswer answer = new PendingAnswer(job, Wait.FILE);
      loop.start(other -> job.terminate());
      try {
        answer.await();
      } finally {
        loop.start(other -> {
          answer.arrived(outcome);
          other.yieldNow();
          loop.say("before");
          job.wake();
        });
        job.waitForWake();
        loop.say("woken");
      }
    });
    assertEquals(List.of("before", "woken"), loop.run());
  }
}
