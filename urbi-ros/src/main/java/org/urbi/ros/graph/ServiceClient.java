package org.urbi.ros.graph;

import java.util.concurrent.CompletableFuture;
import org.urbi.ros.message.ServiceType;
import urbi.UDictionary;

/** What calls a service of another node. */
public interface ServiceClient extends AutoCloseable {
  /** The full name of the service. */
  String service();

  ServiceType type();

  /**
   * Asks the service. The answer fails with a {@link RosException} if the service refuses, or goes.
   * Whoever does not want to wait any longer completes it.
   *
   * @throws org.urbi.ros.message.ValueException if the request is not of the type
   */
  CompletableFuture<UDictionary> request(UDictionary request);

  @Override
  void close();
}
