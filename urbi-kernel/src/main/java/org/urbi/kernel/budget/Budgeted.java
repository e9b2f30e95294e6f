package org.urbi.kernel.budget;

/** An object (a lobby) on whose behalf code runs, and which has a budget. */
public interface Budgeted {
  /** The limits of that code. */
  Budget budget();
}
