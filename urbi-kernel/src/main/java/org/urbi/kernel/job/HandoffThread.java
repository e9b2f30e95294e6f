package org.urbi.kernel.job;

import static java.util.Objects.requireNonNull;

import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/**
 * Runs a job on a virtual thread of the JDK's own scheduler: the tick loop and the job hand the
 * turn to each other, and the one that waits is parked. For programs that embed the kernel without
 * opening {@code java.lang}.
 */
final class HandoffThread implements JobThread {
  private final Factory factory;
  private @Nullable Job job;
  private @Nullable Thread thread;
  private volatile boolean jobHasBaton;

  private HandoffThread(Factory factory, Job job) {
    this.factory = factory;
    this.job = job;
  }

  @Override
  public void resume() {
    jobHasBaton = true;
    if (thread == null) {
      thread = Thread.ofVirtual().unstarted(this::run);
      thread.start();
    } else {
      LockSupport.unpark(thread);
    }
    while (jobHasBaton) {
      LockSupport.park(this);
    }
  }

  private void run() {
    try {
      takeJob().run();
    } finally {
      giveBack();
    }
  }

  /**
   * The thread goes on for a moment after its job has ended, long on a busy machine: what the job
   * referred to must not live that long.
   */
  private Job takeJob() {
    Job own = requireNonNull(job, "a thread runs once");
    job = null;
    return own;
  }

  private void giveBack() {
    jobHasBaton = false;
    LockSupport.unpark(factory.loop);
  }

  @Override
  public void suspend() {
    giveBack();
    while (!jobHasBaton) {
      LockSupport.park(this);
    }
  }

  private Thread running() {
    return requireNonNull(thread, "it runs already");
  }

  @Override
  public void interrupt() {
    running().interrupt();
  }

  @Override
  public StackTraceElement[] stackTrace() {
    return running().getStackTrace();
  }

  @Override
  public boolean isCurrent() {
    return Thread.currentThread() == thread;
  }

  /** Makes the threads of one kernel. */
  static final class Factory implements JobThread.Factory {
    /**
     * The limit of nested calls: the stack of a virtual thread of the JDK is limited by that of its
     * carrier.
     */
    private static final int MAXIMUM_DEPTH = 1_000;

    private volatile @Nullable Thread loop;

    @Override
    public JobThread create(Job job) {
      return new HandoffThread(this, job);
    }

    @Override
    public Thread startLoop(Runnable body) {
      // The loop runs on a virtual thread as well: switching to a platform thread would take six
      // times as long.
      Thread thread = Thread.ofVirtual().name("urbi-kernel").unstarted(body);
      loop = thread;
      thread.start();
      return thread;
    }

    /** No job keeps a thread that the loop needs. */
    @Override
    public void loopEnded() {}

    /** Virtual threads have none of their own. */
    @Override
    public long processorTime() {
      return HoldWatchdog.UNKNOWN;
    }

    /** Nobody knows what virtual threads have allocated, so that of the whole process counts. */
    @Override
    public long allocatedBytes() {
      return ThreadCosts.allocatedBytesOfAll();
    }

    @Override
    public int maximumDepth() {
      return MAXIMUM_DEPTH;
    }
  }
}
