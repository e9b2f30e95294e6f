package org.urbi.kernel.job;

/** Reports to a job that one of the jobs it started and waits for was left by an exception. */
final class ChildFailure extends Unwinding {
  private final transient JobGroup group;

  ChildFailure(JobGroup group) {
    this.group = group;
  }

  JobGroup group() {
    return group;
  }
}
