package org.urbi.kernel.job;

/** The states of a job. */
public enum JobState {
  RUNNABLE("running"),
  RUNNING("running"),
  WAITING("waiting"),
  SLEEPING("sleeping"),
  ENDED("terminated");

  private final String text;

  JobState(String text) {
    this.text = text;
  }

  /** As the manual names it. */
  public String text() {
    return text;
  }
}
