package org.urbi.ros.rtps;

import java.net.InetSocketAddress;

/**
 * A writer or reader of this participant, as those see it that find it partners. With the lock of
 * the participant.
 */
interface LocalEndpoint {
  EndpointInfo info();

  /** Begins to exchange samples with a partner, which listens there. */
  void match(EndpointInfo partner, InetSocketAddress address);

  void unmatch(Guid partner);

  boolean isMatched(Guid partner);

  /** A writer or reader of the same topic does not match: that policy of its is incompatible. */
  void hindered(EndpointInfo other, String policy);
}
