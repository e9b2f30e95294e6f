package org.urbi.ros.two;

import java.io.IOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.urbi.ros.graph.Names;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.message.Definitions;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.InterfaceFiles;

/**
 * Where a node of ROS 2 is.
 *
 * @param domain nodes of other domains are not seen
 * @param range whom it finds: {@code LOCALHOST}, {@code SUBNET} or {@code OFF}
 * @param address where it listens; on loopback, nodes of this machine only
 */
public record TwoSettings(
    Names names, int domain, String range, InetAddress address, Definitions definitions) {
  private static final String RANGE = "ROS_AUTOMATIC_DISCOVERY_RANGE";
  private static final String OFF = "OFF";

  /**
   * What the environment says: {@code ROS_DOMAIN_ID}, {@code ROS_AUTOMATIC_DISCOVERY_RANGE} ({@code
   * LOCALHOST} unless there is one, {@code SUBNET}, {@code OFF}), {@code ROS_IP} (the address of
   * this machine in that subnet, if it has several), {@code ROS_NAMESPACE}, {@code
   * AMENT_PREFIX_PATH}.
   *
   * @param node the name of the node, relative or full
   * @throws RosException if something in it is not right
   */
  public static TwoSettings of(
      Map<String, String> environment, String node, Map<String, String> remappings) {
    String domain = environment.getOrDefault("ROS_DOMAIN_ID", "0").strip();
    String ip = environment.getOrDefault("ROS_IP", "").strip();
    String usual = ip.isEmpty() ? "LOCALHOST" : "SUBNET";
    String range = environment.getOrDefault(RANGE, "").strip().toUpperCase(Locale.ROOT);
    if (range.isEmpty()) range = usual;
    return new TwoSettings(
        Names.of(node, environment.getOrDefault("ROS_NAMESPACE", "/"), remappings),
        domain(domain),
        range,
        address(range, ip),
        new Definitions(Dialect.ROS_2, InterfaceFiles.of(Dialect.ROS_2, environment)));
  }

  /** Whether it looks for nobody, and nobody finds it. */
  public boolean isAlone() {
    return range.equals(OFF);
  }

  private static int domain(String text) {
    try {
      return Integer.parseInt(text.isEmpty() ? "0" : text);
    } catch (NumberFormatException e) {
      throw new RosException("ROS_DOMAIN_ID is a number from 0 to 232, and is '" + text + "'", e);
    }
  }

  private static InetAddress address(String range, String ip) {
    return switch (range) {
      case "LOCALHOST", OFF -> InetAddress.ofLiteral("127.0.0.1");
      case "SUBNET", "SYSTEM_DEFAULT" -> ip.isEmpty() ? ofThisMachine() : literal(ip);
      default ->
          throw new RosException(RANGE + " is LOCALHOST, SUBNET or OFF, and is '" + range + "'");
    };
  }

  private static InetAddress literal(String ip) {
    try {
      return InetAddress.ofLiteral(ip);
    } catch (IllegalArgumentException e) {
      throw new RosException("ROS_IP is an address as 192.168.1.2, and is '" + ip + "'", e);
    }
  }

  /** The address in the first subnet in which others can be found. */
  private static InetAddress ofThisMachine() {
    try {
      for (NetworkInterface each : NetworkInterface.networkInterfaces().toList()) {
        if (!each.isUp() || each.isLoopback() || !each.supportsMulticast()) continue;
        Optional<InetAddress> found =
            each.inetAddresses().filter(Inet4Address.class::isInstance).findFirst();
        if (found.isPresent()) return found.get();
      }
    } catch (IOException e) {
      throw new RosException("the networks of this machine cannot be seen: " + e.getMessage(), e);
    }
    throw new RosException(
        RANGE + " is SUBNET, but no network of this machine has multicast: LOCALHOST, or ROS_IP");
  }
}
