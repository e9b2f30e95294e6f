package org.urbi.ros.rtps;

/** What a participant learns of others. Called by its threads, which must not be held. */
public interface ParticipantListener {
  /** A listener that listens to nothing. */
  ParticipantListener NONE = new ParticipantListener() {};

  /** There is another participant, or it says something new about itself. */
  default void found(ParticipantInfo participant) {}

  /**
   * A participant has gone, or nothing was heard of it for its lease. Its writers and readers have
   * been told of before.
   */
  default void lost(ParticipantInfo participant) {}

  /** There is a writer or reader, or it says something new about itself. */
  default void found(EndpointInfo endpoint) {}

  /** A writer or reader has gone. */
  default void lost(EndpointInfo endpoint) {}

  /** Something went wrong, and was survived. */
  default void trouble(String what, Throwable reason) {}
}
