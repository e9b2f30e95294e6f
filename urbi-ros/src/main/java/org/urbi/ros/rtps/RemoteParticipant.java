package org.urbi.ros.rtps;

import java.net.InetSocketAddress;
import java.util.LinkedHashMap;
import java.util.Map;
import org.urbi.ros.time.SteadyClock;

/** Another participant, and what it has told of its writers and readers. */
final class RemoteParticipant {
  final InetSocketAddress discovery;
  final Map<Guid, EndpointInfo> endpoints = new LinkedHashMap<>();
  private ParticipantInfo info;
  private long heard = SteadyClock.nanoseconds();

  RemoteParticipant(ParticipantInfo info, InetSocketAddress discovery) {
    this.info = info;
    this.discovery = discovery;
  }

  ParticipantInfo info() {
    return info;
  }

  void update(ParticipantInfo newer) {
    info = newer;
  }

  void heard() {
    heard = SteadyClock.nanoseconds();
  }

  /** Nanoseconds until it is taken for dead. */
  long left(long now) {
    return info.lease() == EndpointQos.INFINITE ? EndpointQos.INFINITE : heard + info.lease() - now;
  }
}
