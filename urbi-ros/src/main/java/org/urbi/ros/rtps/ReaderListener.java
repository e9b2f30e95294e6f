package org.urbi.ros.rtps;

/** What happens to a reader. Called by the threads of the participant, which must not be held. */
public interface ReaderListener {
  /** A listener that listens to nothing. */
  ReaderListener NONE = new ReaderListener() {};

  /** There are samples to {@link Reader#take}; said once, until all have been taken. */
  default void available(Reader reader) {}

  /** A writer sends it samples from now on. */
  default void matched(Reader reader, EndpointInfo writer) {}

  /** A writer is gone. */
  default void unmatched(Reader reader, Guid writer) {}

  /** A writer of the topic does not offer what the reader requests: that policy. */
  default void hindered(Reader reader, EndpointInfo writer, String policy) {}

  /** That number of samples of a writer are lost for good. */
  default void lost(Reader reader, Guid writer, long samples) {}

  /** A writer has not shown in time that it is alive, or has shown it again. */
  default void liveliness(Reader reader, Guid writer, boolean alive) {}

  /** No sample came within the deadline. */
  default void deadlineMissed(Reader reader) {}
}
