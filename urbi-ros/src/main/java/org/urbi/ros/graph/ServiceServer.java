package org.urbi.ros.graph;

import java.util.concurrent.CompletionStage;
import org.urbi.ros.message.ServiceType;
import urbi.UDictionary;

/** A service that this node offers. */
public interface ServiceServer extends AutoCloseable {
  /** What answers; called by threads of the network, for several clients at a time. */
  @FunctionalInterface
  interface Handler {
    /** The answer; if it fails, the client is told why. */
    CompletionStage<UDictionary> answer(UDictionary request);
  }

  /** The full name of the service. */
  String service();

  ServiceType type();

  @Override
  void close();
}
