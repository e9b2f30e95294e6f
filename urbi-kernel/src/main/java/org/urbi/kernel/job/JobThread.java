package org.urbi.kernel.job;

/**
 * Carries the stack of a job. The tick loop calls {@link #resume}, the job calls {@link #suspend};
 * exactly one of the two sides runs at a time, also while the job waits inside Java.
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

  /** Interrupts a wait of the job inside Java that blocks the loop; called from another thread. */
  void interrupt();

  /** The Java calls that it is executing; called from another thread. */
  StackTraceElement[] stackTrace();

  /** Whether the calling code runs in the job. */
  boolean isCurrent();

  /** Makes the threads of one kernel. */
  interface Factory {
    JobThread create(Job job);

    /** Starts the thread on which the tick loop runs. */
    Thread startLoop(Runnable loop);

    /** The tick loop has resumed a job for the last time; called on its thread. */
    void loopEnded();

    /**
     * The processor time that the loop and its jobs have had so far, in nanoseconds, or {@link
     * HoldWatchdog#UNKNOWN}; from any thread.
     */
    long processorTime();

    /** How many bytes the loop and its jobs have allocated so far; from any thread. */
    long allocatedBytes();

    /** How many nested calls certainly fit on the stack of a job. */
    int maximumDepth();
  }
}
