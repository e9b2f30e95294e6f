package org.urbi.kernel.journal;

/** Why code that never lets others run is to end where it stands. */
public enum StopReason {
  /** It is not to end. */
  NONE,
  /** Somebody has interrupted it, or has left. */
  REQUESTED,
  /** It has held the kernel for too long. */
  OVERDUE,
  /** It has allocated too much without letting others run. */
  GREEDY
}
