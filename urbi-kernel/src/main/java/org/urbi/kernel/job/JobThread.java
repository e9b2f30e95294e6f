package org.urbi.kernel.job;

import org.urbi.kernel.message.Message;

/**
 * What carries the stack of a job. The tick loop calls {@link #resume}, the job calls {@link
 * #suspend}; exactly one of the two sides runs at a time.
 */
interface JobThread {
  /** Runs the job until it suspends or ends. */
  void resume();

  /**
   * Gives control back to the tick loop until it resumes this job.
   *
   * @throws IllegalStateException when a native frame on the stack makes that impossible
   */
  void suspend();

  /** Ends what the job waits for in Java, while it keeps the loop waiting; from another thread. */
  void interrupt();

  /** What it executes right now, in Java; from another thread. */
  StackTraceElement[] stackTrace();

  /** Whether the code that asks is that of the job. */
  boolean isCurrent();

  /** Makes the threads of one kernel. */
  interface Factory {
    JobThread create(Job job);

    /** Starts the thread on which the tick loop runs. */
    Thread startLoop(Runnable loop);

    /** What a job waited for inside Java code is there; on the thread of the tick loop. */
    void take(Message message);

    /** The tick loop has resumed a job for the last time; called on its thread. */
    void loopEnded();

    /** How many nested calls the stack of a job is sure to hold. */
    int maximumDepth();
  }
}
