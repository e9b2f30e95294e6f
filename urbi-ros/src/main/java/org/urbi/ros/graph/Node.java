package org.urbi.ros.graph;

import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.message.Definitions;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.ServiceType;

/**
 * This program as a node among others. No method waits: what takes its time is promised. Names of
 * topics and services may be relative, they are resolved and remapped as ROS does it.
 */
public interface Node extends AutoCloseable {
  /** The full name: {@code /urbi_4711}. */
  String name();

  Dialect version();

  /** The types that this node knows. */
  Definitions definitions();

  /**
   * Done when a type can be used at once: what has to be loaded for it, libraries of another
   * middleware, is loaded by a thread of its own. Fails with a {@link RosException} if that is not
   * possible.
   */
  default CompletableFuture<Void> prepared(MessageType type) {
    return CompletableFuture.completedFuture(null);
  }

  /**
   * The full name that is meant by one.
   *
   * @throws RosException if it is no name
   */
  String resolve(String name);

  /**
   * Whether the others can be reached: in ROS 1, whether there is a master; in ROS 2, whether the
   * node is up.
   */
  CompletableFuture<Boolean> reachable();

  /** Who does what. Fails with a {@link RosException} if there is nobody to tell. */
  CompletableFuture<GraphSnapshot> graph();

  /**
   * The name of the type that the others use on a topic; fails with a {@link RosException} if there
   * is none, or nobody says.
   */
  CompletableFuture<String> typeOf(String topic);

  /**
   * Done when those have been told who can be told of what was advertised, subscribed and offered
   * until now: the master in ROS 1, or it is seen that there is none; in ROS 2, which has nobody
   * who would confirm it, all are told at once.
   */
  CompletableFuture<Void> settled();

  /**
   * What time it is for this node, in nanoseconds since 1970: that of {@code /clock} if its {@code
   * use_sim_time} says so.
   */
  long now();

  /** Tells people something on {@code /rosout}. */
  void log(Severity severity, String text);

  /** The parameters of this node and of others. */
  ParameterServer parameters();

  /**
   * Has a listener called, on a thread of the network, with each change that the node gets to know.
   *
   * @return what ends that
   */
  Runnable watch(Consumer<GraphSnapshot> listener);

  /**
   * Offers messages on a topic.
   *
   * @throws RosException if the name is no name of a topic
   */
  Publisher advertise(String topic, MessageType type, Qos qos, Publisher.Listener listener);

  /**
   * Listens to a topic.
   *
   * @param type null for that of the publishers
   * @throws RosException if the name is no name of a topic
   */
  Subscription subscribe(
      String topic, @Nullable MessageType type, Qos qos, Subscription.Listener listener);

  /**
   * What calls a service, as soon as that is there; fails with a {@link RosException} if it is not.
   *
   * @param type null for that of the server
   * @param keepAlive whether the connection remains between calls, where it makes a difference
   */
  CompletableFuture<ServiceClient> client(
      String service, @Nullable ServiceType type, boolean keepAlive);

  /**
   * Offers a service.
   *
   * @throws RosException if a service cannot have that name
   */
  ServiceServer serve(String service, ServiceType type, ServiceServer.Handler handler);

  /** The actions of this node and of others. */
  Actions actions();

  /** Says good-bye, and ends everything. */
  @Override
  void close();
}
