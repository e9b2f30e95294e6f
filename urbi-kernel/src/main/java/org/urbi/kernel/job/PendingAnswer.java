package org.urbi.kernel.job;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Outcome;
import org.urbi.kernel.message.Receiver;

/**
 * A result that another thread computes and for which a job waits while other jobs run. Simulated
 * time runs at the pace of real time until the result is there, even if the job no longer waits.
 */
public final class PendingAnswer implements Receiver {
  private final Scheduler scheduler;
  private final Job job;
  private final Wait of;
  private final int number;
  private @Nullable Outcome outcome;
  private boolean abandoned;
  private Runnable before = () -> {};

  /**
   * Begins to wait; in the job.
   *
   * @param of whose result it is, for those who look
   */
  public PendingAnswer(Job job, Wait of) {
    this.job = job;
    this.of = of;
    scheduler = job.scheduler();
    number = scheduler.inbox().register(this);
    scheduler.pace().begin();
  }

  /** Delivers the result; from any thread, once. */
  public void post(Outcome what) {
    scheduler.inbox().post(new Message.Answer(number, what));
  }

  /** Has something done by the kernel thread before the result is delivered. */
  public void before(Runnable action) {
    before = action;
  }

  @Override
  public void take(Message message) {
    before.run();
    arrived(((Message.Answer) message).outcome());
  }

  /** Delivers the result without a message; on the kernel thread. */
  public void arrived(Outcome what) {
    scheduler.inbox().forget(number);
    scheduler.pace().end();
    outcome = what;
    if (!abandoned) {
      job.wake();
    }
  }

  /** Makes the job wait for the result. */
  public Outcome await() {
    try {
      while (outcome == null) {
        job.waitForWake(of);
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
