package org.urbi.ros.graph;

import org.urbi.ros.message.MessageType;
import urbi.UDictionary;

/** What this node says on a topic. */
public interface Publisher extends AutoCloseable {
  /** Who listens; called by threads of the network. */
  interface Listener {
    /** A node has subscribed. */
    default void connected(String node) {}

    /** A node has unsubscribed, or has gone. */
    default void disconnected(String node) {}

    /** Something keeps a node from being heard; others hear all the same. For people. */
    default void failed(String reason) {}
  }

  /** The full name of the topic. */
  String topic();

  MessageType type();

  /**
   * Sends a message to whoever has subscribed. Does not wait: what a slow subscriber does not take
   * is dropped, the oldest first.
   *
   * @throws org.urbi.ros.message.ValueException if it is not of the type
   */
  void publish(UDictionary message);

  /** How many have subscribed. */
  int subscribers();

  @Override
  void close();
}
