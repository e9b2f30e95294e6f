package org.urbi.ros.graph;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiConsumer;
import urbi.UValue;

/**
 * The parameters of nodes. In ROS 1 they are kept in one place for all nodes. In ROS 2 each node
 * has its own: {@code name} is one of this node, {@code /other:name} one of another node.
 */
public interface ParameterServer {
  /** The value of a parameter; fails if there is none. */
  CompletableFuture<UValue> get(String name);

  /**
   * Sets a parameter; one of this node, or of all, need not be there. Fails if another node refuses
   * it.
   *
   * @throws RosException if it is nothing that a parameter can be
   */
  CompletableFuture<Void> set(String name, UValue value);

  /**
   * Sets a parameter, of this node or of all nodes, unless it is set already, and describes it.
   *
   * @param description is known to those who ask in ROS 2; ROS 1 has no place for it
   * @throws RosException if the value does not fit it
   */
  CompletableFuture<Void> declare(String name, UValue value, ParameterDescription description);

  /** Whether there is a parameter. */
  CompletableFuture<Boolean> has(String name);

  /** Deletes a parameter of this node, or of all; fails if there is none. */
  CompletableFuture<Void> delete(String name);

  /** The names of all parameters of this node, or of all. */
  CompletableFuture<List<String>> names();

  /** The names of all parameters of a node. */
  CompletableFuture<List<String>> namesOf(String node);

  /**
   * Has a listener told each parameter of this node that another one has set; by threads of the
   * network. In ROS 1, nobody tells that of all parameters.
   */
  default void watch(BiConsumer<String, UValue> listener) {}
}
