package org.urbi.kernel.journal;

/** Why code that never lets others run is to end where it stands. */
public enum StopReason {
  /** The job is not to end. */
  NONE,
  /** Somebody has interrupted it, or has left. */
  REQUESTED,
  /** The job has held the kernel for too long. */
  OVERDUE,
  /** The job has allocated too much without letting others run. */
  GREEDY
}
