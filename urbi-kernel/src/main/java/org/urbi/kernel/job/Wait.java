package org.urbi.kernel.job;

/** What a job waits for, in the words of the manual: for people who look. */
public enum Wait {
  /** Nothing but its turn. */
  TURN("running"),

  /** A time. */
  TIME("time"),

  /** An event. */
  EVENT("event"),

  /** That an expression is true. */
  CONDITION("condition"),

  /** The end of the jobs that it has started: {@code &} and {@code ,}. */
  JOBS("jobs"),

  /** More input of its connection. */
  INPUT("input"),

  /** A mutex or a semaphore. */
  LOCK("lock"),

  /** A signal or a value that another job sends. */
  SIGNAL("signal"),

  /** A file, a process, a socket, or something else outside. */
  FILE("file"),

  /** A component: a UObject here or elsewhere. */
  COMPONENT("UObject"),

  /** What nobody has a name for. */
  ANOTHER("waiting");

  private final String text;

  Wait(String text) {
    this.text = text;
  }

  /** Its name for people. */
  public String text() {
    return text;
  }
}
