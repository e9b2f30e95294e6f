package org.urbi.ros.graph;

import java.nio.ByteBuffer;
import org.urbi.ros.message.MessageType;
import urbi.UDictionary;

/** What this node hears on a topic. */
public interface Subscription extends AutoCloseable {
  /** Who listens; called by threads of the network, one at a time. */
  interface Listener {
    void received(UDictionary message);

    /**
     * Each message is offered as its publisher has sent it, before it is decoded. The bytes are
     * only lent.
     *
     * @return whether that is all that is wanted of it: {@link #received} does not get it
     */
    default boolean takes(ByteBuffer sent) {
      return false;
    }

    /** The type of the messages is known: at once, or when the first publisher has told it. */
    default void typed(MessageType type) {}

    /** Something went wrong with a publisher; others are still heard. The text is for people. */
    default void failed(String reason) {}
  }

  /** The full name of the topic. */
  String topic();

  /** How many nodes are being heard. */
  int publishers();

  @Override
  void close();
}
