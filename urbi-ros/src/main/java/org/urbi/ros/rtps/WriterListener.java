package org.urbi.ros.rtps;

/** What happens to a writer. Called by the threads of the participant, which must not be held. */
public interface WriterListener {
  /** A listener that listens to nothing. */
  WriterListener NONE = new WriterListener() {};

  /** A reader gets its samples from now on. */
  default void matched(Writer writer, EndpointInfo reader) {}

  /** A reader is gone. */
  default void unmatched(Writer writer, Guid reader) {}

  /** A reader of the topic requests what the writer does not offer: that policy. */
  default void hindered(Writer writer, EndpointInfo reader, String policy) {}

  /** After {@link Writer#write} had no room, or {@link Writer#hasRoom} said so: there is again. */
  default void room(Writer writer) {}
}
