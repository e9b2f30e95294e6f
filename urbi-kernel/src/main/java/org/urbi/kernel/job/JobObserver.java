package org.urbi.kernel.job;

/** Measures what a job does. */
public interface JobObserver {
  /** The job lets others run. */
  void switchedOut();

  /** The job has its turn again. */
  void switchedIn();

  /** The observer of a job that this one starts. */
  JobObserver forChild();
}
