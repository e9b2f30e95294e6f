package org.urbi.ros.rtps;

import java.net.InetSocketAddress;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Brings writers and readers together: those of this participant with those of others, and with
 * each other.
 */
final class Matching {
  private record Remote(EndpointInfo info, InetSocketAddress address) {}

  private final Map<Guid, LocalEndpoint> own = new LinkedHashMap<>();
  private final Map<Guid, Remote> others = new LinkedHashMap<>();
  private final InetSocketAddress ownAddress;

  Matching(InetSocketAddress ownAddress) {
    this.ownAddress = ownAddress;
  }

  Iterable<LocalEndpoint> own() {
    return own.values();
  }

  void add(LocalEndpoint endpoint) {
    for (LocalEndpoint each : own.values()) {
      match(endpoint, each.info(), ownAddress);
      match(each, endpoint.info(), ownAddress);
    }
    own.put(endpoint.info().guid(), endpoint);
    for (Remote each : others.values()) match(endpoint, each.info, each.address);
  }

  void remove(LocalEndpoint endpoint) {
    Guid guid = endpoint.info().guid();
    own.remove(guid);
    own.values().forEach(each -> each.unmatch(guid));
  }

  /** Someone else's writer or reader is there, or says something new about itself. */
  void add(EndpointInfo info, InetSocketAddress address) {
    Remote before = others.put(info.guid(), new Remote(info, address));
    boolean moved = before != null && !before.address.equals(address);
    for (LocalEndpoint each : own.values()) {
      if (moved) each.unmatch(info.guid());
      match(each, info, address);
    }
  }

  void remove(Guid guid) {
    if (others.remove(guid) != null) own.values().forEach(each -> each.unmatch(guid));
  }

  private static void match(
      LocalEndpoint endpoint, EndpointInfo partner, InetSocketAddress address) {
    if (!endpoint.info().concerns(partner)) return;
    String policy = endpoint.info().hinders(partner);
    boolean isMatched = endpoint.isMatched(partner.guid());
    if (policy.isEmpty() && !isMatched) endpoint.match(partner, address);
    if (!policy.isEmpty()) {
      if (isMatched) endpoint.unmatch(partner.guid());
      endpoint.hindered(partner, policy);
    }
  }
}
