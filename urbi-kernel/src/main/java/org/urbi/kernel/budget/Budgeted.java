package org.urbi.kernel.budget;

/** Something for which code runs, and which has a budget. */
public interface Budgeted {
  /** What that code may have. */
  Budget budget();
}
