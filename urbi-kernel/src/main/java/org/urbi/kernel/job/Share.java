package org.urbi.kernel.job;

import java.util.Comparator;

/** The jobs of one budget in a rush, and what the rounds that they had have cost the others. */
final class Share {
  // Those that Comparator makes are in no start-up cache.
  static final Comparator<Share> AGE = (a, b) -> Long.compare(a.number, b.number);
  static final Comparator<Share> PLACE =
      (a, b) -> a.place == b.place ? AGE.compare(a, b) : Long.compare(a.place, b.place);

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
