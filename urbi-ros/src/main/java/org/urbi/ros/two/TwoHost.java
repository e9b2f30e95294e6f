package org.urbi.ros.two;

import java.util.concurrent.CompletableFuture;
import org.urbi.ros.graph.Node;

/** A node of ROS 2, for what consists of topics and services whatever carries these. */
public interface TwoHost extends Node {
  /**
   * The type of a service that is there, told by a thread that may wait; fails if there is none.
   *
   * @param full the full name of the service
   * @param missing what people are told if it is not there
   */
  CompletableFuture<String> typeOfService(String full, String missing);

  /** Where people are told of what goes wrong. */
  Reports reports();
}
