package org.urbi.ros.rtps;

/** Who gets the samples of a reader, in the order of each writer. */
interface SampleSink {
  /**
   * Whether there was room for it. Otherwise the writer keeps it, until {@link
   * StatefulReader#resume} asks for it.
   */
  boolean deliver(Sample sample);

  /** So many samples of a writer will never come. */
  void lost(Guid writer, long samples);

  /** Another writer has taken the place of that one, under the same name. */
  default void restarted(Guid writer) {}
}
