package org.urbi.kernel.job;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Outcome;
import org.urbi.kernel.message.Receiver;

/**
 * What a job waits for while the others go on, and another thread brings about. A simulated time
 * goes at the machine's pace until it is there, be the job still waiting or not.
 */
public final class PendingAnswer implements Receiver {
  private final Scheduler scheduler;
  private final Job job;
  private final int number;
  private @Nullable Outcome outcome;
  private boolean abandoned;

  /** Begins to wait; in the job. */
  public PendingAnswer(Job job) {
    this.job = job;
    scheduler = job.scheduler();
    number = scheduler.inbox().register(this);
    scheduler.pace().begin();
  }

  /** Says that it is there; from any thread, once. */
  public void post(Outcome what) {
    scheduler.inbox().post(new Message.Answer(number, what));
  }

  @Override
  public void take(Message message) {
    arrived(((Message.Answer) message).outcome());
  }

  /** It is there, and nobody needs to be told by a message; on the kernel thread. */
  public void arrived(Outcome what) {
    scheduler.inbox().forget(number);
    scheduler.pace().end();
    outcome = what;
    if (!abandoned) {
      job.wake();
    }
  }

  /** The job waits until it is there. */
  public Outcome await() {
    try {
      while (outcome == null) {
        job.waitForWake();
      }
    } finally {
      abandon();
    }
    return outcome;
  }

  /** The job does not wait for it any more. */
  public void abandon() {
    abandoned = true;
  }
}
