package org.urbi.kernel.job;

/** Reports to a job that one of the jobs it started and waits for was left by an exception. */
final class ChildFailure extends ControlFlowException {
  private final transient JobGroup group;
  private final transient Throwable failure;

  ChildFailure(JobGroup group, Throwable failure) {
    this.group = group;
    this.failure = failure;
  }

  JobGroup group() {
    return group;
  }

  /** The exception that ended the child job. */
  Throwable failure() {
    return failure;
  }
}
