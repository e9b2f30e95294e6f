package org.urbi.kernel.job;

/** The jobs of one budget in a rush, and what the rounds that they had have cost the others. */
final class Share {
  final JobList jobs = new JobList();
  final long number;

  /** Whether it takes part in this rush. */
  boolean active;

  /** For how many rounds that were cut short it was to blame. */
  long roundsCut;

  /** The least is served first; constant while it is to be served. */
  long place;

  Share(long number, long roundsCut) {
    this.number = number;
    this.roundsCut = roundsCut;
  }
}
